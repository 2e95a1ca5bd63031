// Symbols of quantities: stored as plain ASCII ("u_c", "b_1x", "alpha_7"), shown with Greek letters and
// subscripts.
#pragma once

#include <string>
#include <string_view>

namespace covaria {

/// "alpha_7" -> "α₇" where Unicode has the subscript characters, else "α_7".
std::string symbol_to_unicode(std::string_view symbol);
/// "alpha_7" -> "<i>α</i><sub>7</sub>", for HTML and rich text.
std::string symbol_to_html(std::string_view symbol);

}  // namespace covaria
