// Numbers for tables.
#include "ui/models/number_words.h"

#include <QLocale>
#include <cmath>

#include "core/report/number_format.h"
#include "core/report/table_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString localized(const std::string& number) {
    return to_qt(typeset_number(number)).replace('.', QLocale().decimalPoint()).replace('-', QChar(0x2212));
}

QString degrees_of_freedom_text(double value) {
    return localized(format_degrees_of_freedom(value));
}

}  // namespace covaria::ui
