// Equations as people read them: fractions, roots, powers, symbols, as a tree that is written as Unicode text
// or MathML, or drawn.
#pragma once

#include <string>
#include <vector>

#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria {

struct Formula {
    enum class Kind {
        symbol,    ///< `symbol`
        number,    ///< a number, with its unit if it has one: "20 °C"
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
    Symbol symbol = {};
    std::vector<Formula> parts = {};

    static Formula leaf(Kind kind, std::string text) { return {kind, std::move(text), {}, {}}; }
    static Formula of_symbol(Symbol symbol) { return {Kind::symbol, {}, std::move(symbol), {}}; }
    static Formula row(std::vector<Formula> parts) { return {Kind::row, {}, {}, std::move(parts)}; }
    /// Whether there is nothing to show.
    bool empty() const { return kind == Kind::row && parts.empty(); }
};

/// The formula with its numbers as the reader writes them; ";" parts arguments where "," is the decimal sign.
Formula with_numbers(Formula formula, const NumberLocale& numbers);
/// "R = (V/I)·cos(φ)".
std::string to_unicode(const Formula& formula);
/// A whole <math> element (MathML Core).
std::string to_mathml(const Formula& formula);

}  // namespace covaria
