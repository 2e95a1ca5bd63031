// Correlation coefficients of pairs of components, declared or implied by arithmetic combination.
#pragma once

#include <cstddef>

#include "core/quantity/input_quantity.h"

namespace covaria::detail {

/// Coefficient of two different components: declared, +-1 where an arithmetic quantity has both, else 0.
double correlation_between(const InputSet& inputs, std::size_t first, std::size_t second);

}  // namespace covaria::detail
