// Words for messages about set-ups: the nearest known name, what a dimension is called, plain numbers.
#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/unit.h"

namespace covaria {

/// The candidate nearest to `name` (edit distance of at most a third of its length, and never all of it),
/// or empty.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);
/// " (did you mean 'alpha'?)", or empty when nothing is near.
Message did_you_mean(const std::string& name, const std::vector<std::string>& candidates);
/// "'a', 'b' and 'c'".
std::string listed(const std::vector<std::string>& names);

/// "a length", "a force", "a pure number"; "measured in 1/K" for a dimension without a common name.
Message dimension_words(const Unit& unit);

/// The shortest decimal text that reads back as the same number: 688 -> "688", 0.066 -> "0.066".
std::string shortest_number(double value);
/// Number for ranges in messages: twelve digits, so that a conversion of units leaves no tail ("50", not
/// "49.999999999999996"); infinity in words.
std::string readable_number(double value);
/// "3 N", "0.5" (unit one).
std::string quantity_words(double value, const Unit& unit);

}  // namespace covaria
