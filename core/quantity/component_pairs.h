// Components that belong together: correlation coefficients of pairs, sets of dependent components.
#pragma once

#include <cstddef>
#include <vector>

#include "core/quantity/input_quantity.h"

namespace covaria::detail {

/// Coefficients between these components, by their places in the list, each pair once: declared, +-1 where an
/// arithmetic quantity has both. Pairs that are not named are independent.
std::vector<ComponentCorrelation> correlations_among(const InputSet& inputs,
                                                     const std::vector<std::size_t>& components);

/// Components of a quantity with their correlation coefficients with its total deviation: 1 for a single one,
/// u_j/u for independent ones. Held components are left out.
std::vector<Share> correlations_with_total(const InputSet& inputs, std::size_t quantity);

/// Components that are correlated with each other, directly or through others: sorted sets of two or more.
std::vector<std::vector<std::size_t>> correlated_sets(std::size_t components,
                                                      const std::vector<ComponentCorrelation>& correlations);

/// Components that are not independent of each other, by correlation (as from `resolved_correlations`), a
/// shared estimate of variance or a vector of random direction: sorted sets of two or more.
std::vector<std::vector<std::size_t>> dependent_sets(const InputSet& inputs,
                                                     const std::vector<ComponentCorrelation>& correlations);

}  // namespace covaria::detail
