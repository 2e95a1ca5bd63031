#include "core/text/text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/printable.h"
#include "core/base/superscript.h"

namespace covaria {

namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

constexpr std::array<Replacement, 38> subscripts{
    {{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"}, {"6", "₆"}, {"7", "₇"},
     {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"-", "₋"}, {"=", "₌"}, {"(", "₍"}, {")", "₎"}, {"a", "ₐ"},
     {"e", "ₑ"}, {"h", "ₕ"}, {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"l", "ₗ"}, {"m", "ₘ"}, {"n", "ₙ"},
     {"o", "ₒ"}, {"p", "ₚ"}, {"r", "ᵣ"}, {"s", "ₛ"}, {"t", "ₜ"}, {"u", "ᵤ"}, {"v", "ᵥ"}, {"x", "ₓ"},
     {"β", "ᵦ"}, {"γ", "ᵧ"}, {"ρ", "ᵨ"}, {"φ", "ᵩ"}, {"χ", "ᵪ"}, {"−", "₋"}}};

constexpr std::array<Replacement, 8> superscript_letters{
    {{"+", "⁺"}, {"-", "⁻"}, {"−", "⁻"}, {"(", "⁽"}, {")", "⁾"}, {"n", "ⁿ"}, {"i", "ⁱ"}, {"T", "ᵀ"}}};

template <class Table>
std::string_view found_in(const Table& table, std::string_view letter) {
    const auto it =
        std::find_if(table.begin(), table.end(), [&](const Replacement& r) { return r.first == letter; });
    return it == table.end() ? std::string_view() : it->second;
}

/// `replace` gives an empty text for what it cannot replace.
template <class Replace>
std::optional<std::string> replaced_all(std::string_view text, const Replace& replace) {
    std::string replaced;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string found(replace(text.substr(0, length)));
        if (found.empty()) return std::nullopt;
        replaced += found;
        text.remove_prefix(length);
    }
    return replaced;
}

}  // namespace

Text::Text(std::string words) {
    append({std::move(words), Script::line, false});
}

void Text::append(Span span) {
    if (span.letters.empty()) return;
    if (!spans_.empty() && spans_.back().script == span.script && spans_.back().italic == span.italic)
        spans_.back().letters += span.letters;
    else
        spans_.push_back(std::move(span));
}

Text& Text::operator+=(const Text& more) {
    const std::vector<Span> added = more.spans_;
    for (const Span& span : added) append(span);
    return *this;
}

bool Text::has_scripts() const {
    return std::any_of(spans_.begin(), spans_.end(), [](const Span& s) { return s.script != Script::line; });
}

bool Text::is_plain() const {
    return spans_.size() == 1 && spans_[0].script == Script::line && !spans_[0].italic;
}

std::string Text::letters() const {
    std::string all;
    for (const Span& span : spans_) all += span.letters;
    return all;
}

Text Text::part(std::size_t begin, std::size_t end) const {
    Text found;
    std::size_t at = 0;
    for (const Span& span : spans_) {
        const std::size_t from = std::max(begin, at), to = std::min(end, at + span.letters.size());
        if (from < to) found.append({span.letters.substr(from - at, to - from), span.script, span.italic});
        at += span.letters.size();
    }
    return found;
}

std::size_t character_length(std::string_view text) {
    const auto c = static_cast<unsigned char>(text.front());
    const std::size_t length = c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
    return std::min(length, text.size());
}

std::optional<std::string> unicode_subscripts(std::string_view text) {
    return replaced_all(text, [](std::string_view letter) { return found_in(subscripts, letter); });
}

std::optional<std::string> unicode_superscripts(std::string_view text) {
    return replaced_all(text, [](std::string_view letter) {
        const bool figure = letter.size() == 1 && letter[0] >= '0' && letter[0] <= '9';
        return figure ? superscript(letter[0] - '0') : std::string(found_in(superscript_letters, letter));
    });
}

std::string_view letter_of_subscript(std::string_view character) {
    const auto it = std::find_if(subscripts.begin(), subscripts.end(),
                                 [&](const Replacement& r) { return r.second == character; });
    return it == subscripts.end() ? std::string_view() : it->first;
}

bool TextPattern::has_words() const {
    const std::string_view before_unit = std::string_view(words).substr(0, words.find('('));
    return before_unit.find_first_not_of("%123456789 ,") != std::string_view::npos;
}

TextPattern pattern_of(const Text& text) {
    TextPattern pattern;
    bool in_symbol = false;
    for (const Text::Span& span : text.spans()) {
        const bool words = span.script == Script::line && !span.italic;
        if (words) pattern.words += span.letters;
        const bool begins = !words && (!in_symbol || (span.script == Script::line && span.italic));
        if (begins) {
            pattern.symbols.emplace_back();
            pattern.words.append("%").append(std::to_string(pattern.symbols.size()));
        }
        if (!words) pattern.symbols.back() += Text(span);
        in_symbol = !words;
    }
    return pattern;
}

std::string to_unicode(const Text& text) {
    std::string out;
    for (const Text::Span& span : text.spans()) {
        if (span.script == Script::line) out += span.letters;
        if (span.script == Script::below)
            out += unicode_subscripts(span.letters).value_or("_" + span.letters);
        if (span.script == Script::above)
            out += unicode_superscripts(span.letters).value_or("^" + span.letters);
    }
    return out;
}

std::string to_html(const Text& text) {
    std::string out;
    for (const Text::Span& span : text.spans()) {
        const char* tag = span.script == Script::below   ? "sub"
                          : span.script == Script::above ? "sup"
                          : span.italic                  ? "i"
                                                         : nullptr;
        const std::string letters = escape_html(span.letters);
        out += tag ? "<" + std::string(tag) + ">" + letters + "</" + tag + ">" : letters;
    }
    return out;
}

std::string escape_html(std::string_view text) {
    static constexpr std::array<Replacement, 4> table{
        {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}}};
    const std::string shown = printable(text);
    std::string out;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const std::string_view letter = std::string_view(shown).substr(i, 1);
        const std::string_view entity = found_in(table, letter);
        out += entity.empty() ? letter : entity;
    }
    return out;
}

}  // namespace covaria
