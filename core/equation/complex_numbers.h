// Complex quantities of equations, lowered to pairs of real ones before anything is compiled (JCGM 102 6.4).
//
//     Z = V/I * polar(1, phi)       complex; its parts are Z_re and Z_im
//     R = re(Z); X = im(Z)          abs, arg, re and im give real numbers, conj a complex one
#pragma once

#include "core/equation/parser.h"

namespace covaria::equation {

/// The same equations in real numbers: a complex definition Z becomes the definitions Z_re and Z_im of one
/// statement, a complex equation of a system two. A text without complex numbers stays as it is. Mistakes
/// (a comparison of complex numbers, a function that has no complex form, a name that a part would take) are
/// reported with their places.
ParsedText in_real_numbers(const ParsedText& parsed, TextProblems& problems);

/// Names of definitions that are complex.
std::vector<std::string> complex_definitions(const ParsedText& parsed);

/// Names of the two parts of a complex definition.
std::string real_part_of(const std::string& name);
std::string imaginary_part_of(const std::string& name);

}  // namespace covaria::equation
