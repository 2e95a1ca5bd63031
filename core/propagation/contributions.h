// Who contributes how much: the budget (first order) and one-at-a-time Monte Carlo.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/base/error.h"
#include "core/propagation/first_order.h"
#include "core/propagation/run_context.h"
#include "core/propagation/trial_block_runner.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// share_j = c_j u_j sum_k r_jk c_k u_k / u^2(y); rows sorted by falling |share|.
UncertaintyBudget budget_of(const InputSet& inputs, const LawOfPropagation& law);

/// u of every output from the first `trials` trials, on this thread; empty when stopped. `failed`, if not
/// null: trials without a value.
std::vector<double> trial_uncertainties(const TrialSource& source, std::uint64_t trials, RunMonitor& monitor,
                                        std::uint64_t* failed);

/// Adds to each row u(y) by Monte Carlo with everything but the row's component held, from the first
/// `trials` trials of the run's own draws. Error: cancelled.
Result<void> add_one_at_a_time(UncertaintyBudget& budget, const RunContext& context, const InputSet& inputs,
                               const Correlations& correlations, std::uint64_t trials);

/// u with everything of one contributor held, and of it alone, first order; empty with fewer than two
/// contributors that contribute.
std::vector<ContributorResult> contributors_of(const InputSet& inputs, const LawOfPropagation& law,
                                               const Correlations& correlations);

/// Adds the same by Monte Carlo, from the first `trials` trials of the run's own draws. Error: cancelled.
Result<void> add_contributor_trials(std::vector<ContributorResult>& contributors, const RunContext& context,
                                    const InputSet& inputs, const LawOfPropagation& law,
                                    const Correlations& correlations, std::uint64_t trials);

}  // namespace covaria::detail
