// Result line of an output from its trials.
#pragma once

#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// Estimate, u, k and U become those of the trials. `degrees_of_freedom`: the least of the Student t's that
/// reach the output (`least_degrees_of_freedom`). With 2 or fewer there is no standard deviation, and u is
/// infinite; with 1 or fewer no expectation, and the estimate stays f at the estimates. `result`:
/// method, probability and fixed k.
void take_trials(OutputResult& output, MonteCarloOutput trials, double degrees_of_freedom,
                 const UncertaintyResult& result);

}  // namespace covaria::detail
