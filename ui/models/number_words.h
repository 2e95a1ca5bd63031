// Formatted numbers of the core in the user's locale.
#pragma once

#include <QString>
#include <string>

#include "core/text/numbers.h"
#include "ui/theme/number_locale.h"

namespace covaria::ui {

/// Text of a number with a decimal point, with the locale's decimal mark, a true minus sign and powers of
/// ten.
QString localized(const std::string& number);

}  // namespace covaria::ui
