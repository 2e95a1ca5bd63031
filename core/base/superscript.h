// Superscript figures of Unicode.
#pragma once

#include <string>

namespace covaria {

/// -5 -> "⁻⁵"
std::string superscript(int exponent);

}  // namespace covaria
