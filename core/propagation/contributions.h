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

/// Adds to each row u(y) by Monte Carlo with everything but the row's component held, from the first
/// `trials` trials of the run's own draws. Error: cancelled.
Result<void> add_one_at_a_time(UncertaintyBudget& budget, const RunContext& context, const InputSet& inputs,
                               const Correlations& correlations, std::uint64_t trials);

}  // namespace covaria::detail
