// The head of a column and the title of an axis: a name and the unit that its numbers are in, as their
// quotient (ISO 80000-1, 7.1).
#pragma once

#include <string>

#include "core/base/unit.h"
#include "core/text/text.h"

namespace covaria {

/// "u / mm", "c / (nm/K)", "(value + U) / mm"; the name alone where the unit is one. Without a name, the
/// unit.
Text head_with_unit(const Text& name, const Unit& unit);
/// The head for a unit as it is shown, empty of a number, and numbers in units of 10^exponent:
/// "x / (10⁻⁶ mm)", "density / (10⁶/mm)", "u(x) / 10⁻⁶".
Text head_with_unit(const Text& name, const std::string& shown_unit, int exponent = 0);

}  // namespace covaria
