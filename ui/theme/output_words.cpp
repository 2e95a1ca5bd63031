#include "ui/theme/output_words.h"

#include "core/text/symbol.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

Text output_words(const std::string& symbol, const Name& group) {
    const Text of_symbol = symbol_text(symbol);
    return group.empty() ? of_symbol : of_symbol + (", " + to_std(to_qt(said_name(group))));
}

}  // namespace covaria::ui
