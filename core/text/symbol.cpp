// Symbols of quantities as people read them: Greek letters, subscripts and superscripts in Unicode or HTML.
#include "core/text/symbol.h"

#include <algorithm>
#include <array>
#include <cctype>
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

/// Other letters and code points for the same ones.
constexpr std::array<Replacement, 5> further_letters{
    {{"mu", "\u00B5"}, {"Delta", "\u2206"}, {"Omega", "\u2126"}, {"epsilon", "\u03F5"}, {"phi", "ϕ"}}};

/// Empty: no name of a letter.
std::string_view greek_named(std::string_view name) {
    const auto it =
        std::find_if(greek.begin(), greek.end(), [&](const Replacement& r) { return r.first == name; });
    return it == greek.end() ? std::string_view() : it->second;
}

/// "theta" -> "θ", "theta1" -> "θ1", "DeltaT" -> "ΔT".
std::string with_greek(std::string_view word) {
    constexpr std::string_view difference = "Delta";
    const std::size_t end = word.find_last_not_of("0123456789") + 1;
    if (const std::string_view letter = greek_named(word.substr(0, end)); !letter.empty())
        return std::string(letter) + std::string(word.substr(end));
    if (end == difference.size() + 1 && word.starts_with(difference))
        return "Δ" + std::string(word.substr(difference.size()));
    return std::string(word);
}

/// "xbar" -> x with a bar, "betahat" -> β with a hat; other words only become Greek letters.
std::string base_letters(std::string_view word) {
    constexpr std::array<Replacement, 2> accents{{{"bar", "\u0304"}, {"hat", "\u0302"}}};
    for (const auto& [ending, accent] : accents) {
        if (word.size() <= ending.size() || !word.ends_with(ending)) continue;
        const std::string_view letter = word.substr(0, word.size() - ending.size());
        if (letter.size() == 1 || !greek_named(letter).empty())
            return with_greek(letter) + std::string(accent);
    }
    return with_greek(word);
}

bool is_combining(std::string_view character) {
    return character.starts_with('\xCC') || character.starts_with('\xCD');
}

/// Letters, figures and what joins them in a symbol; of other characters those of two bytes that are letters
/// (Latin, Greek, Cyrillic) or accents.
bool is_word_character(std::string_view character) {
    const auto c = static_cast<unsigned char>(character.front());
    if (c < 0x80) return std::isalnum(c) || c == '_' || c == '^' || c == '\'';
    return character.size() == 2 && (c >= 0xC3 || character == "µ") && character != "×" && character != "÷";
}

bool begins_with_letter(std::string_view word) {
    return std::string_view("0123456789_^'").find(word.front()) == std::string_view::npos;
}

/// A single letter, one with an accent, a Greek one by its name, a difference of such: "x", "x̄", "alpha",
/// "ΔT".
bool is_letter(std::string_view word) {
    if (base_letters(word) != word) return true;
    if (word.starts_with("Δ") && word.size() > 2) word.remove_prefix(2);
    std::size_t letters = 0;
    while (!word.empty()) {
        const std::string_view character = word.substr(0, character_length(word));
        if (!is_combining(character)) ++letters;
        word.remove_prefix(character.size());
    }
    return letters == 1;
}

/// "u_by", "alpha_7", but not "file_name": a letter with subscripts.
bool is_subscripted_letter(std::string_view word) {
    const std::size_t end = word.find_first_of("_^");
    return end != std::string_view::npos && end > 0 && end + 1 < word.size() &&
           is_letter(word.substr(0, end));
}

/// Whether a word is a symbol in an equation, where short words are, too: "KS_j", "Rot_i", "d'_hij".
bool is_subscripted_word(std::string_view word) {
    constexpr std::size_t longest = 4;
    const std::size_t end = word.find_first_of("_^");
    if (end == std::string_view::npos || end == 0 || end + 1 >= word.size()) return false;
    return end <= longest || is_subscripted_letter(word);
}

/// End of the run of characters that are all of a word, or all not.
std::size_t end_of_run(std::string_view text, std::size_t begin) {
    const auto is_word = [&](std::size_t i) {
        return is_word_character(text.substr(i, character_length(text.substr(i))));
    };
    std::size_t end = begin;
    while (end < text.size() && is_word(end) == is_word(begin)) end += character_length(text.substr(end));
    return end;
}

bool is_figure(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whether a subscript that ends before `end` goes on: all in braces ("z_{i−1}"); a comma goes on
/// ("p_1x,1"), the one after it does not ("p_1x, pose 1", "u_x,u_y"), and so does a hyphen between figures
/// ("L_1-2") where it cannot be a minus sign.
bool goes_on(std::string_view text, std::size_t begin, std::size_t end, bool equation) {
    if (end + 1 >= text.size() || text.substr(begin, end - begin).find('_') == std::string_view::npos)
        return false;
    if (text[end] == ',') return std::isalnum(static_cast<unsigned char>(text[end + 1])) != 0;
    return !equation && text[end] == '-' && is_figure(text[end - 1]) && is_figure(text[end + 1]);
}

std::size_t end_of_symbol(std::string_view text, std::size_t begin, bool equation) {
    std::size_t end = end_of_run(text, begin);
    if (end < text.size() && text[end] == '{' && text[end - 1] == '_')
        if (const std::size_t closed = text.find('}', end); closed != std::string_view::npos)
            return closed + 1;
    while (goes_on(text, begin, end, equation)) {
        const std::size_t next = end_of_run(text, end + 1);
        if (text.substr(end, next - end).find_first_of("_^") != std::string_view::npos) break;
        end = next;
    }
    return end;
}

/// `is_symbol` says which words are symbols.
template <class IsSymbol>
Text with_symbols(std::string_view text, const IsSymbol& is_symbol, bool equation = false) {
    Text out;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = end_of_run(text, begin);
        const bool word = is_word_character(text.substr(begin, character_length(text.substr(begin)))) &&
                          begins_with_letter(text.substr(begin));
        if (word) end = end_of_symbol(text, begin, equation);
        const std::string_view part = text.substr(begin, end - begin);
        out += word && is_symbol(part) ? symbol_text(part) : Text(part);
        begin = end;
    }
    return out;
}

}  // namespace

Symbol parse_symbol(std::string_view plain) {
    Symbol symbol;
    std::size_t end = std::min(plain.find_first_of("_^", 1), plain.size());
    symbol.base = base_letters(plain.substr(0, end));
    while (end < plain.size()) {
        const std::size_t next = std::min(plain.find_first_of("_^", end + 1), plain.size());
        std::string& target = plain[end] == '^' ? symbol.superscript : symbol.subscript;
        if (!target.empty()) target += ',';
        std::string_view part = plain.substr(end + 1, next - end - 1);
        if (part.starts_with('{') && part.ends_with('}')) part = part.substr(1, part.size() - 2);
        target += with_greek(part);
        end = next;
    }
    return symbol;
}

Text to_text(const Symbol& symbol) {
    return Text(Text::Span{symbol.base, Script::line, true}) +
           Text(Text::Span{symbol.subscript, Script::below, false}) +
           Text(Text::Span{symbol.superscript, Script::above, false});
}

std::vector<ScriptPart> script_parts(std::string_view script) {
    const auto is_letter_of_a_run = [](std::string_view character) {
        const auto c = static_cast<unsigned char>(character.front());
        return c >= 0x80 ? is_word_character(character) : std::isalpha(c) != 0;
    };
    std::vector<ScriptPart> parts;
    for (std::size_t begin = 0; begin < script.size();) {
        const auto character = [&](std::size_t at) {
            return script.substr(at, character_length(script.substr(at)));
        };
        const bool of_letters = is_letter_of_a_run(character(begin));
        std::size_t end = begin;
        while (end < script.size() && is_letter_of_a_run(character(end)) == of_letters)
            end += character(end).size();
        const std::string_view run = script.substr(begin, end - begin);
        const bool is_one = run.size() == character_length(run);
        const bool is_capital = std::isupper(static_cast<unsigned char>(run.front())) != 0;
        const bool italic = of_letters && ((is_one && !is_capital) ||
                                           run.find_first_not_of("hijk") == std::string_view::npos);
        if (!parts.empty() && parts.back().italic == italic)
            parts.back().letters += run;
        else
            parts.push_back({std::string(run), italic});
        begin = end;
    }
    return parts;
}

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
        const std::string_view character = symbol.substr(0, character_length(symbol));
        const std::string_view lowered = letter_of_subscript(character);
        if (!lowered.empty() && !below && !plain.ends_with('_')) plain += '_';
        below = !lowered.empty();
        const std::string_view letter = below ? lowered : character;
        const std::optional<GreekLetter> greek_letter = greek_letter_at(letter);
        plain += greek_letter ? greek_letter->name : letter;
        symbol.remove_prefix(character.size());
    }
    return plain;
}

Text symbol_text(std::string_view plain) {
    return to_text(parse_symbol(plain));
}

std::string symbol_to_unicode(std::string_view plain) {
    return to_unicode(symbol_text(plain));
}

Text symbols_text(std::string_view text) {
    return with_symbols(text, [](std::string_view) { return true; });
}

Text running_text(std::string_view text) {
    return with_symbols(text, is_subscripted_letter);
}

Text equation_text(std::string_view text) {
    return with_symbols(
        text, [](std::string_view word) { return is_letter(word) || is_subscripted_word(word); }, true);
}

Text title_text(std::string_view title) {
    return looks_like_symbol(title) ? symbol_text(title) : running_text(title);
}

bool looks_like_symbol(std::string_view title) {
    const bool word = !title.empty() && end_of_symbol(title, 0, false) == title.size() &&
                      is_word_character(title.substr(0, character_length(title)));
    return word && (title.size() == 1 || title.find('_') != std::string_view::npos ||
                    base_letters(title) != title || is_letter(title));
}

}  // namespace covaria
