// Parsed equations as formulas.
#pragma once

#include <vector>

#include "core/equation/parser.h"
#include "core/text/formula.h"

namespace covaria::equation {

/// The statements, one formula each. Statements too long to be read as a formula give one word, their text
/// being what the set-up shows.
std::vector<Formula> formulas(const ParsedText& parsed);

}  // namespace covaria::equation
