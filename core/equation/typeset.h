// Equations as people read them: fractions, roots, powers, Greek letters, as a tree that is written as
// Unicode text or MathML, or drawn.
#pragma once

#include <string>
#include <vector>

#include "core/equation/parser.h"

namespace covaria::equation {

struct Formula {
    enum class Kind {
        symbol,    ///< `text` is the name: "alpha_s"
        number,    ///< with its unit, if it has one: "20 °C"
        word,      ///< name of a function, "if", "and"
        sign,      ///< operator between parts of a row
        row,       ///< parts one after the other
        fraction,  ///< numerator, denominator
        power,     ///< base, exponent
        root,      ///< under the sign; `text` is the degree, empty for the square root
        fence,     ///< one part in parentheses, or between bars: `text` is "(" or "|"
    };
    Kind kind = Kind::row;
    std::string text = {};
    std::vector<Formula> parts = {};
};

/// The statements, one formula each. Statements too long to be read as a formula give one word, their text
/// being what the set-up shows.
std::vector<Formula> formulas(const ParsedText& parsed);

/// "R = (V/I)·cos(φ)".
std::string to_unicode(const Formula& formula);
/// A whole <math> element (MathML Core).
std::string to_mathml(const Formula& formula);

}  // namespace covaria::equation
