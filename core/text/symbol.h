// Symbols of quantities: stored as plain ASCII ("u_c", "b_1x", "alpha_7"), read into a value with Greek
// letters, subscripts and superscripts. The only place that knows what a symbol looks like, alone and among
// words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/text.h"

namespace covaria {

/// Letters in Unicode: "alpha_7^2" is {"α", "7", "2"}.
struct Symbol {
    std::string base;         ///< letters with their accent: "x̄"
    std::string subscript;    ///< several are joined by commas
    std::string superscript;  ///< several are joined by commas
    bool operator==(const Symbol&) const = default;
};
Symbol parse_symbol(std::string_view plain);
Text to_text(const Symbol& symbol);

/// A subscript or superscript as ISO 80000-1 sets it: a single small letter (or Greek one) is a quantity or a
/// running number, and so are several of h, i, j, k: italic. Words, labels and figures are upright.
struct ScriptPart {
    std::string letters;
    bool italic = false;
};
std::vector<ScriptPart> script_parts(std::string_view script);

/// A Greek letter at the beginning of a text: its name ("alpha") and its length in bytes.
struct GreekLetter {
    std::string_view name;
    std::size_t bytes = 0;
};
std::optional<GreekLetter> greek_letter_at(std::string_view text);
/// Symbol as it is stored: "α_7", "α₇" -> "alpha_7"; other texts stay.
std::string plain_symbol(std::string_view symbol);

/// The text of the symbol that `plain` stands for.
Text symbol_text(std::string_view plain);
/// "alpha_7" -> "α₇", "theta1" -> "θ1" where Unicode has the subscript characters, else "α_7".
std::string symbol_to_unicode(std::string_view plain);

/// Symbols among other marks ("b_1x, b_2x … b_9z", "U(x)"): every word is one.
Text symbols_text(std::string_view text);
/// Running text, names: letters with subscripts ("u_by", "alpha_7", "ΔT_1") are symbols, other words
/// ("file_name") stay.
Text running_text(std::string_view text);
/// An equation as text: single letters and names of Greek letters are symbols as well.
Text equation_text(std::string_view text);
/// A title: a symbol if it looks like one ("u_x", "x", but not "point"), else running text.
Text title_text(std::string_view title);
bool looks_like_symbol(std::string_view title);

}  // namespace covaria
