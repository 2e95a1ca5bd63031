// Is a normal distribution an acceptable description of an output?
#pragma once

#include <cstdint>

#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// Verdict by skewness, kurtosis, u and the symmetric interval of `trials` trials. With many trials every
/// distribution differs from a normal one significantly; the verdict asks whether U = k u would mislead.
NormalityVerdict normality_of(const MonteCarloOutput& output, std::uint64_t trials, double probability);

}  // namespace covaria::detail
