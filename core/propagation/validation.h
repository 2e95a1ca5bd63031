// Validation of the law of propagation by Monte Carlo (JCGM 101 clause 8).
#pragma once

#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// |y - U_p - y_low| and |y + U_p - y_high| against the numerical tolerance of u(y) with `digits` in `unit`,
/// where U_p = t_p(nu_eff) u(y) at the probability of the interval, whatever coverage factor is displayed.
FirstOrderOutput::Validation validation_of(const FirstOrderOutput& first_order,
                                           const CoverageInterval& symmetric, double probability,
                                           const Unit& unit, int digits);

}  // namespace covaria::detail
