// Validation of the law of propagation by Monte Carlo (JCGM 101 clause 8).
#pragma once

#include <cstdint>

#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// |y - U_p - y_low| and |y + U_p - y_high| against the numerical tolerance of u(y) with `digits` in `unit`,
/// where U_p = t_p(nu_eff) u(y) at the probability of the interval, whatever coverage factor is displayed. It
/// is close where the larger of them is within two standard errors of the ends of that tolerance: those of
/// the quantiles of a normal distribution from so many trials.
FirstOrderOutput::Validation validation_of(const FirstOrderOutput& first_order,
                                           const CoverageInterval& symmetric, double probability,
                                           const Unit& unit, int digits, std::uint64_t trials);

}  // namespace covaria::detail
