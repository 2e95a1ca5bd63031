// From the trials of an output to its result line.
#pragma once

#include "core/propagation/first_order.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// The smallest degrees of freedom of the Student t's that reach the output in Monte Carlo: up to 2 there is
/// no standard deviation, up to 1 no expectation. An angle is bounded by its branch and always has both.
double smallest_degrees_of_freedom(const InputSet& inputs, const LawOfPropagation& law, std::size_t output,
                                   const OutputQuantity& quantity);

/// Estimate, u, k and U become those of the trials; `degrees_of_freedom` as above. Without a standard
/// deviation u is infinite, without an expectation the estimate stays f at the estimates. `result`:
/// method, probability and fixed k.
void take_trials(OutputResult& output, MonteCarloOutput trials, double degrees_of_freedom,
                 const UncertaintyResult& result);

}  // namespace covaria::detail
