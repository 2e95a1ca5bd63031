// Symbols of quantities as people read them: Greek letters, subscripts and superscripts in Unicode or HTML.
#include "core/base/symbol.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace covaria {

namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

constexpr std::array<Replacement, 38> greek{
    {{"alpha", "α"},   {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"},
     {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"}, {"lambda", "λ"},  {"mu", "μ"},
     {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},   {"sigma", "σ"},   {"tau", "τ"},
     {"upsilon", "υ"}, {"phi", "φ"},   {"chi", "χ"},    {"psi", "ψ"},   {"omega", "ω"},   {"Gamma", "Γ"},
     {"Delta", "Δ"},   {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},    {"Pi", "Π"},      {"Sigma", "Σ"},
     {"Upsilon", "Υ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},    {"Omega", "Ω"}, {"varphi", "ϕ"},  {"vartheta", "ϑ"},
     {"infty", "∞"},   {"ell", "ℓ"}}};

constexpr std::array<Replacement, 38> subscripts{
    {{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"}, {"6", "₆"}, {"7", "₇"},
     {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"-", "₋"}, {"=", "₌"}, {"(", "₍"}, {")", "₎"}, {"a", "ₐ"},
     {"e", "ₑ"}, {"h", "ₕ"}, {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"l", "ₗ"}, {"m", "ₘ"}, {"n", "ₙ"},
     {"o", "ₒ"}, {"p", "ₚ"}, {"r", "ᵣ"}, {"s", "ₛ"}, {"t", "ₜ"}, {"u", "ᵤ"}, {"v", "ᵥ"}, {"x", "ₓ"},
     {"β", "ᵦ"}, {"γ", "ᵧ"}, {"ρ", "ᵨ"}, {"φ", "ᵩ"}, {"χ", "ᵪ"}, {"−", "₋"}}};

constexpr std::array<Replacement, 17> superscripts{{{"0", "⁰"},
                                                    {"1", "¹"},
                                                    {"2", "²"},
                                                    {"3", "³"},
                                                    {"4", "⁴"},
                                                    {"5", "⁵"},
                                                    {"6", "⁶"},
                                                    {"7", "⁷"},
                                                    {"8", "⁸"},
                                                    {"9", "⁹"},
                                                    {"+", "⁺"},
                                                    {"-", "⁻"},
                                                    {"(", "⁽"},
                                                    {")", "⁾"},
                                                    {"n", "ⁿ"},
                                                    {"i", "ⁱ"},
                                                    {"T", "ᵀ"}}};

template <class Table>
const std::string_view* find_in(const Table& table, std::string_view key) {
    const auto it =
        std::find_if(table.begin(), table.end(), [&](const Replacement& r) { return r.first == key; });
    return it == table.end() ? nullptr : &it->second;
}

/// Other letters and code points for the same ones.
constexpr std::array<Replacement, 5> further_letters{
    {{"mu", "\u00B5"}, {"Delta", "\u2206"}, {"Omega", "\u2126"}, {"epsilon", "\u03F5"}, {"phi", "ϕ"}}};

/// "theta" -> "θ", "theta1" -> "θ1".
std::string with_greek(std::string_view word) {
    const std::size_t end = word.find_last_not_of("0123456789") + 1;
    const std::string_view* letter = find_in(greek, word.substr(0, end));
    return letter != nullptr ? std::string(*letter) + std::string(word.substr(end)) : std::string(word);
}

/// "xbar" -> x with a bar, "betahat" -> β with a hat; other words only become Greek letters.
std::string base_letters(std::string_view word) {
    constexpr std::array<Replacement, 2> accents{{{"bar", "\u0304"}, {"hat", "\u0302"}}};
    for (const auto& [ending, accent] : accents) {
        if (word.size() <= ending.size() || !word.ends_with(ending)) continue;
        const std::string_view letter = word.substr(0, word.size() - ending.size());
        if (letter.size() == 1 || find_in(greek, letter) != nullptr)
            return with_greek(letter) + std::string(accent);
    }
    return with_greek(word);
}

struct SymbolParts {
    std::string base;
    std::string subscript;  ///< parts joined by commas
    std::string superscript;
};

SymbolParts split(std::string_view symbol) {
    SymbolParts parts;
    std::size_t end = std::min(symbol.find_first_of("_^", 1), symbol.size());
    parts.base = base_letters(symbol.substr(0, end));
    while (end < symbol.size()) {
        const std::size_t next = std::min(symbol.find_first_of("_^", end + 1), symbol.size());
        std::string& target = symbol[end] == '^' ? parts.superscript : parts.subscript;
        if (!target.empty()) target += ',';
        target += with_greek(symbol.substr(end + 1, next - end - 1));
        end = next;
    }
    return parts;
}

/// Length in bytes of the UTF-8 character that starts with `first`.
std::size_t character_length(char first) {
    const auto c = static_cast<unsigned char>(first);
    return c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
}

/// All characters from the table, or nothing if one is missing: half-lowered subscripts are unreadable.
template <class Table>
std::optional<std::string> replaced_all(const Table& table, std::string_view text) {
    std::string replaced;
    while (!text.empty()) {
        const std::size_t length = std::min(character_length(text.front()), text.size());
        const std::string_view* found = find_in(table, text.substr(0, length));
        if (found == nullptr) return std::nullopt;
        replaced += *found;
        text.remove_prefix(length);
    }
    return replaced;
}

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

}  // namespace

std::optional<GreekLetter> greek_letter_at(std::string_view text) {
    const auto starts = [&](const Replacement& r) { return text.starts_with(r.second); };
    if (text.empty() || static_cast<unsigned char>(text.front()) < 0x80) return std::nullopt;
    if (const auto it = std::find_if(further_letters.begin(), further_letters.end(), starts);
        it != further_letters.end())
        return GreekLetter{it->first, it->second.size()};
    const auto it = std::find_if(greek.begin(), greek.end(), starts);
    if (it == greek.end() || it->first == "infty" || it->first == "ell") return std::nullopt;
    return GreekLetter{it->first, it->second.size()};
}

std::string plain_symbol(std::string_view symbol) {
    std::string plain;
    bool below = false;
    while (!symbol.empty()) {
        const std::size_t length = std::min(character_length(symbol.front()), symbol.size());
        const std::string_view character = symbol.substr(0, length);
        const auto subscript = std::find_if(subscripts.begin(), subscripts.end(),
                                            [&](const Replacement& r) { return r.second == character; });
        const bool lowered = subscript != subscripts.end();
        if (lowered && !below && !plain.ends_with('_')) plain += '_';
        below = lowered;
        const std::string_view letter = lowered ? subscript->first : character;
        const std::optional<GreekLetter> greek_letter = greek_letter_at(letter);
        plain += greek_letter ? greek_letter->name : letter;
        symbol.remove_prefix(length);
    }
    return plain;
}

std::string symbol_to_unicode(std::string_view symbol) {
    const SymbolParts parts = split(symbol);
    std::string text = parts.base;
    if (!parts.subscript.empty())
        text += replaced_all(subscripts, parts.subscript).value_or("_" + parts.subscript);
    if (!parts.superscript.empty())
        text += replaced_all(superscripts, parts.superscript).value_or("^" + parts.superscript);
    return text;
}

std::string symbol_to_html(std::string_view symbol) {
    const SymbolParts parts = split(symbol);
    std::string html = "<i>" + escaped(parts.base) + "</i>";
    if (!parts.subscript.empty()) html += "<sub>" + escaped(parts.subscript) + "</sub>";
    if (!parts.superscript.empty()) html += "<sup>" + escaped(parts.superscript) + "</sup>";
    return html;
}

}  // namespace covaria
