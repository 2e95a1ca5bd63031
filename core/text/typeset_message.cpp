#include "core/text/typeset_message.h"

#include <vector>

#include "core/base/placeholders.h"

namespace covaria {

Text TypesetMessage::in(const DocumentLanguage& language) const {
    const std::string said = language.say(pattern_);
    return symbol_.empty() ? Text(said) : fill_placeholders<Text>(said, std::vector{symbol_});
}

}  // namespace covaria
