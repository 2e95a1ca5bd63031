// Results against requirements: target uncertainty, conformity with a tolerance (JCGM 106, ISO 14253-1).
#pragma once

#include <optional>
#include <vector>

#include "core/result/uncertainty_result.h"

namespace covaria {

/// Judges a requirement. The verdict follows from it and the result, and is kept nowhere: a changed one is
/// judged at once, without another run. A result that does not represent the measurand is not judged. What it
/// takes to meet a target is in reverse_budget.h.
RequirementResult judge(const UncertaintyResult& result, const OutputRequirement& requirement);
std::vector<RequirementResult> judge(const UncertaintyResult& result,
                                     const std::vector<OutputRequirement>& requirements);

/// Judged, target met where there is one, and accepted where there are limits.
bool is_met(const RequirementResult& verdict);
/// Whether all verdicts on an output are met; nothing where none is on it.
std::optional<bool> are_met(const std::vector<RequirementResult>& verdicts, std::size_t output);

/// Tolerance and acceptance limits; infinite where there is none.
struct ToleranceLimits {
    double lower = -infinity, upper = infinity;
    double accept_lower = -infinity, accept_upper = infinity;
};
/// Global risks of a decision rule for a normal prior and a normal measuring system (JCGM 106 9.5, Eqs
/// 17-20), and those under the condition that it was accepted, or rejected.
RequirementResult::GlobalRisks global_risks(const ToleranceLimits& limits, double prior_mean,
                                            double prior_standard_deviation, double u);

}  // namespace covaria
