// Numbers as they are typed and pasted: digits in groups of three, as results are written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace covaria {

/// Bytes of the number with which `text` begins, sign and point or comma included, if its digits stand in
/// groups of three between spaces of any kind: "12 345.000 25 mm" -> 13. 0: it has no groups. The 1 of a unit
/// is none: "0.125 1/K".
std::size_t length_in_groups(std::string_view text);
/// "12 345.000 25" -> "12345.00025".
std::string without_group_spaces(std::string_view number);

}  // namespace covaria
