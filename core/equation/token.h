// The text of equations as tokens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/equation/place.h"

namespace covaria::equation {

enum class TokenKind { number, name, sign, unit, end_of_statement, end_of_text };

struct Token {
    TokenKind kind = TokenKind::end_of_text;
    std::string text =
        {};  ///< Greek letters by name, signs in ASCII ("*", "^", "<="), a unit without brackets
    double number = 0.0;
    Place place = {};
};

/// More characters than this are refused: no measurement equation is so long.
inline constexpr std::size_t longest_text = 50'000;

/// The tokens up to the first character that cannot be read (with a problem), always ended by end_of_text.
/// A line ends a statement unless a parenthesis is open or the line ends with an operator. "#" starts a
/// comment.
std::vector<Token> tokens_of(std::string_view text, TextProblems& problems);

}  // namespace covaria::equation
