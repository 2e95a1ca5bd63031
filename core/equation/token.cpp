// The lexer: numbers, names, signs, units in brackets, comments.
#include "core/equation/token.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/text/symbol.h"

namespace covaria::equation {

namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

/// Characters that people type or paste, in the ASCII that the parser reads.
constexpr std::array<Replacement, 14> sign_characters{{{"·", "*"},
                                                       {"⋅", "*"},
                                                       {"×", "*"},
                                                       {"−", "-"},
                                                       {"–", "-"},
                                                       {"÷", "/"},
                                                       {"∕", "/"},
                                                       {"²", "^2"},
                                                       {"³", "^3"},
                                                       {"≤", "<="},
                                                       {"≥", ">="},
                                                       {"≠", "!="},
                                                       {"\u00a0", " "},
                                                       {"√", "sqrt"}}};

template <std::size_t N>
const Replacement* starting_with(const std::array<Replacement, N>& table, std::string_view text) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Replacement& r) { return text.starts_with(r.first); });
    return found == table.end() ? nullptr : &*found;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

class Lexer {
public:
    Lexer(std::string_view text, TextProblems& problems) : text_(text), problems_(problems) {}

    std::vector<Token> run() {
        while (readable_ && at_ < text_.size()) next();
        if (tokens_.empty() || tokens_.back().kind != TokenKind::end_of_statement)
            push(TokenKind::end_of_statement, "", 0);
        push(TokenKind::end_of_text, "", 0);
        return std::move(tokens_);
    }

private:
    std::string_view rest() const { return text_.substr(at_); }

    void push(TokenKind kind, std::string text, std::size_t characters, double number = 0.0) {
        tokens_.push_back({kind, std::move(text), number, {line_, column_, characters}});
        column_ += characters;
    }

    void stop(const Message& message, std::size_t characters = 1) {
        problems_.push_back({{line_, column_, characters}, message});
        readable_ = false;
    }

    void next() {
        const char c = text_[at_];
        if (c == '\n' || c == ';') return end_statement(c);
        if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (c == ' ' || c == '\t' || c == '\r') {
            ++at_, ++column_;
        } else if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
            number();
        } else if (c == '[') {
            unit();
        } else if (is_letter(c) || greek_letter_at(rest())) {
            name();
        } else {
            sign();
        }
    }

    /// Inside parentheses and behind an operator a line goes on.
    void end_statement(char c) {
        const bool goes_on = c == '\n' && (open_ > 0 || ends_with_operator());
        if (!goes_on && !tokens_.empty() && tokens_.back().kind != TokenKind::end_of_statement)
            push(TokenKind::end_of_statement, "", 0);
        if (c == ';') {
            ++column_;
            open_ = 0;
        } else {
            ++line_, column_ = 1;
        }
        ++at_;
    }

    bool ends_with_operator() const {
        return !tokens_.empty() && tokens_.back().kind == TokenKind::sign && tokens_.back().text != ")";
    }

    void number() {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        const auto length = static_cast<std::size_t>(end - (text_.data() + at_));
        if (error == std::errc::result_out_of_range || !std::isfinite(value))
            return stop(tell<"this number is too large or too small to compute with">(),
                        std::max<std::size_t>(length, 1));
        push(TokenKind::number, std::string(rest().substr(0, length)), length, value);
        at_ += length;
    }

    void name() {
        std::string text;
        std::size_t characters = 0;
        while (at_ < text_.size()) {
            if (const auto letter = greek_letter_at(rest())) {
                text += letter->name;
                at_ += letter->bytes;
            } else if (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_') {
                text += text_[at_++];
            } else {
                break;
            }
            ++characters;
        }
        push(TokenKind::name, std::move(text), characters);
    }

    void unit() {
        const std::size_t close = text_.find_first_of("]\n", at_);
        if (close == std::string_view::npos || text_[close] == '\n')
            return stop(tell<"the bracket of a unit is not closed: write ']' behind the unit">());
        const std::string_view inside = text_.substr(at_ + 1, close - at_ - 1);
        const auto continuations = std::count_if(inside.begin(), inside.end(), is_continuation);
        push(TokenKind::unit, std::string(inside),
             inside.size() + 2 - static_cast<std::size_t>(continuations));
        at_ = close + 1;
    }

    void sign() {
        static constexpr std::array<std::string_view, 16> signs{"**", "<=", ">=", "==", "!=", "<", ">", "=",
                                                                "+",  "-",  "*",  "/",  "^",  "(", ")", ","};
        if (const Replacement* r = starting_with(sign_characters, rest())) return replaced(*r);
        if (text_[at_] == ':') return take_sign(":");
        for (const std::string_view s : signs)
            if (rest().starts_with(s)) return take_sign(s);
        std::size_t end = at_ + 1;
        while (end < text_.size() && is_continuation(text_[end])) ++end;
        stop(tell<"the character '%1' does not belong in an equation">(
            std::string(text_.substr(at_, end - at_))));
    }

    void take_sign(std::string_view s) {
        if (s == "(") ++open_;
        if (s == ")" && open_ > 0) --open_;
        push(TokenKind::sign, s == "**" ? "^" : std::string(s), s.size());
        at_ += s.size();
    }

    void replaced(const Replacement& r) {
        at_ += r.first.size();
        if (r.second == " ") {
            ++column_;
        } else if (r.second == "sqrt") {
            push(TokenKind::name, "sqrt", 1);
        } else if (r.second.size() == 2 && r.second.front() == '^') {
            push(TokenKind::sign, "^", 0);
            push(TokenKind::number, std::string(r.second.substr(1)), 1, r.second[1] - '0');
        } else {
            push(TokenKind::sign, std::string(r.second), 1);
        }
    }

    std::string_view text_;
    TextProblems& problems_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t column_ = 1;
    std::size_t open_ = 0;
    bool readable_ = true;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text, TextProblems& problems) {
    if (text.size() > longest_text) {
        problems.push_back({{1, 1, 1},
                            tell<"the equations have %1 characters; more than %2 are not read: put tables of "
                                 "data into assets or observations">(text.size(), longest_text)});
        text = {};
    }
    return Lexer(text, problems).run();
}

}  // namespace covaria::equation
