// Text as a value: letters on the line, below and above it. Made from symbols, names and words where they
// enter; realised as Unicode, as HTML, or drawn span by span.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace covaria {

enum class Script { line, below, above };

class Text {
public:
    struct Span {
        std::string letters;
        Script script = Script::line;
        bool italic = false;  ///< base of a symbol
        auto operator<=>(const Span&) const = default;
    };

    Text() = default;
    Text(std::string words);                                    ///< the words as they are, on the line
    Text(std::string_view words) : Text(std::string(words)) {}  ///< the same
    Text(const char* words) : Text(std::string(words)) {}       ///< the same
    explicit Text(Span span) { append(std::move(span)); }

    Text& operator+=(const Text& more);
    friend Text operator+(Text first, const Text& second) { return std::move(first += second); }
    auto operator<=>(const Text&) const = default;

    const std::vector<Span>& spans() const { return spans_; }
    bool empty() const { return spans_.empty(); }
    bool has_scripts() const;
    /// Words alone: no symbol among them.
    bool is_plain() const;
    /// All letters in their order, whatever their script: words and units are looked for in them.
    std::string letters() const;
    /// The bytes [begin, end) of `letters()`, with their scripts.
    Text part(std::size_t begin, std::size_t end = std::string::npos) const;

private:
    void append(Span span);
    std::vector<Span> spans_;  ///< none is empty; neighbours differ
};

/// The words of a text with "%1", "%2" for its symbols: "Observations of %1".
struct TextPattern {
    std::string words;
    std::vector<Text> symbols;
    bool has_words() const;  ///< beside symbols and a unit in parentheses
};
TextPattern pattern_of(const Text& text);

/// "b₁ₓ", "u_c": with the subscripts and superscripts that Unicode has, else after "_" and "^".
std::string to_unicode(const Text& text);
/// "<i>b</i><sub>1x</sub>", escaped.
std::string to_html(const Text& text);
std::string escape_html(std::string_view text);

/// The characters as the subscripts or superscripts that Unicode has; nothing if one has none:
/// half-lowered subscripts are unreadable.
std::optional<std::string> unicode_subscripts(std::string_view text);
std::optional<std::string> unicode_superscripts(std::string_view text);
/// The letter that a Unicode subscript stands for ("₁" -> "1"); empty if it is none.
std::string_view letter_of_subscript(std::string_view character);
/// Length in bytes of the UTF-8 character at the beginning of `text`, which is not empty.
std::size_t character_length(std::string_view text);

}  // namespace covaria
