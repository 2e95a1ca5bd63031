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

/// The components of a budget, in the order of those of the inputs.
std::vector<BudgetComponent> budget_components(const InputSet& inputs);
/// Rows by falling |share|; of equal ones in the order that they have.
void sort_rows(std::vector<BudgetRow>& rows);

/// u of every output from the first `trials` trials, on this thread; empty when stopped. `failed`, if not
/// null: trials without a value.
std::vector<double> trial_uncertainties(const TrialSource& source, std::uint64_t trials, RunMonitor& monitor,
                                        std::uint64_t* failed);

/// Adds to each row u(y) by Monte Carlo with everything but the row's component held, from the first
/// `trials` trials of the run's own draws. Error: cancelled.
Result<void> add_one_at_a_time(UncertaintyBudget& budget, const RunContext& context, const InputSet& inputs,
                               const Correlations& correlations, std::uint64_t trials);

/// u of every output without each contributor, and of it alone, output by output. Not for two threads at a
/// time; `correlations` outlive it.
class ContributorSums {
public:
    ContributorSums(const InputSet& inputs, const LawOfPropagation& law, const Correlations& correlations);
    /// With fewer than two there is nothing to tell apart.
    bool are_several() const { return results_.size() > 1; }
    void take(std::size_t output, const std::vector<PropagationTerm>& terms, bool is_known);
    std::vector<ContributorResult> take_results() { return std::move(results_); }

private:
    static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
    /// Adds the variance that components of contributors a and b (which may be the same) bring in together.
    void add(std::size_t a, std::size_t b, double variance);

    const Correlations& correlations_;
    std::vector<std::size_t> who_;  ///< number of the contributor that brings in each component
    std::vector<ContributorResult> results_;
    std::vector<double> part_, without_, alone_;
};

/// u with everything of one contributor held, and of it alone, first order; empty with fewer than two
/// contributors that contribute.
std::vector<ContributorResult> contributors_of(const InputSet& inputs, const LawOfPropagation& law,
                                               const Correlations& correlations);

/// Adds the same by Monte Carlo, from the first `trials` trials of the run's own draws. Error: cancelled.
Result<void> add_contributor_trials(std::vector<ContributorResult>& contributors, const RunContext& context,
                                    const InputSet& inputs, const LawOfPropagation& law,
                                    const Correlations& correlations, std::uint64_t trials);

}  // namespace covaria::detail
