// Law of propagation of models with more sensitivity coefficients than memory holds: an output at a time, of
// which what results state is kept and the coefficients are not.
#pragma once

#include <memory>
#include <vector>

#include "core/propagation/first_order.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// What is kept in place of terms: budgets whose smaller components are one row for each group of quantities,
/// and u without and of each contributor.
struct CondensedTerms {
    UncertaintyBudget budget;
    std::vector<ContributorResult> contributors;
};

/// The law at `law.inputs`, where estimates and u of the components are known already: its covariances,
/// degrees of freedom, and condensed terms. `most_rows`: budget rows of all outputs together, without those
/// of the rests; each output has the twenty largest at least.
void condense(const SensitivitySource& source, const MeasurementModel& model, const InputSet& inputs,
              const Correlations& correlations, std::size_t most_rows, LawOfPropagation& law);

}  // namespace covaria::detail
