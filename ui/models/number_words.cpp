// Numbers for tables.
#include "ui/models/number_words.h"

#include "ui/document/quantity_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString localized(const std::string& number) {
    return to_qt(typeset_number(number, user_numbers()));
}

}  // namespace covaria::ui
