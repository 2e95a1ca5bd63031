// Symbols of quantities: stored as plain ASCII ("u_c", "b_1x", "alpha_7"), shown with Greek letters and
// subscripts.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace covaria {

/// A Greek letter at the beginning of a text: its name ("alpha") and its length in bytes.
struct GreekLetter {
    std::string_view name;
    std::size_t bytes = 0;
};
std::optional<GreekLetter> greek_letter_at(std::string_view text);
/// As it is stored: "α_7", "α₇" -> "alpha_7"; other texts stay.
std::string plain_symbol(std::string_view symbol);

/// "alpha_7" -> "α₇", "theta1" -> "θ1" where Unicode has the subscript characters, else "α_7".
std::string symbol_to_unicode(std::string_view symbol);
/// "alpha_7" -> "<i>α</i><sub>7</sub>", for HTML and rich text.
std::string symbol_to_html(std::string_view symbol);

}  // namespace covaria
