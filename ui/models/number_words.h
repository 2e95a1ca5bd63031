// Formatted numbers of the core in the user's locale.
#pragma once

#include <QString>
#include <string>

namespace covaria::ui {

/// Text of a number with a decimal point, with the locale's decimal mark, a true minus sign and powers of ten
/// as in reports: "−6,1×10⁻⁵".
QString localized(const std::string& number);
/// Effective degrees of freedom: whole numbers, "∞".
QString degrees_of_freedom_text(double value);

}  // namespace covaria::ui
