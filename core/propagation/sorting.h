// Sorting of many numbers that are spread without large gaps, as tails of distributions are.
#pragma once

#include <vector>

namespace covaria::detail {

/// Greatest first. Numbers must be finite.
void sort_descending(std::vector<double>& values);

}  // namespace covaria::detail
