// Results against requirements: target uncertainty and what it takes, conformity with a tolerance (JCGM 106,
// ISO 14253-1).
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/run_control.h"
#include "core/model/measurement_model.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// Of one output; SI.
struct OutputRequirement {
    std::size_t output = 0;
    std::optional<double> target_uncertainty = {};
    std::optional<double> lower_limit = {}, upper_limit = {};
    double guard_factor = 1.0;
    std::optional<double> prior_mean = {}, prior_standard_deviation = {};
};

/// `result` is that of `model` with its inputs. Where Monte Carlo ran, the probability of conformance is also
/// counted in its first (at most 10^6) trials, made again. Error: cancelled, numeric.
Result<std::vector<RequirementResult>> check_requirements(const MeasurementModel& model,
                                                          const UncertaintyResult& result,
                                                          const std::vector<OutputRequirement>& requirements,
                                                          const RunControl& control = {});

/// What the standard uncertainty of each component, alone, must become so that u(y) does not exceed
/// `wanted`, by the law of propagation with its correlations: the largest such u, below that of now.
std::vector<RequirementResult::Reduction> reductions(const UncertaintyResult& result, std::size_t output,
                                                     double wanted);

/// Tolerance and acceptance limits; infinite where there is none.
struct ToleranceLimits {
    double lower = -infinity, upper = infinity;
    double accept_lower = -infinity, accept_upper = infinity;
};
/// Global risks of a decision rule for a normal prior and a normal measuring system (JCGM 106 9.5, Eqs
/// 17-20).
RequirementResult::GlobalRisks global_risks(const ToleranceLimits& limits, double prior_mean,
                                            double prior_standard_deviation, double u);

}  // namespace covaria
