// A quantity that is known by values of it, or by a histogram of them, instead of by a mean (JCGM 101 6.4.1).
#pragma once

#include <string>
#include <vector>

#include "core/kinds/equation/setup.h"

namespace covaria::equation_model {

/// Distribution from the rows of a quantity, SI: each value with its weight, or rectangular cells between the
/// edges. Errors: rows that are missing, weights that are missing or of no sum, edges that do not rise.
Result<Distribution> sampled_distribution(const std::vector<Observation>& rows, const std::string& quantity,
                                          const Unit& unit, bool histogram);

}  // namespace covaria::equation_model
