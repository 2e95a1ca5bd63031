// Variance reduction of a Monte Carlo run: other points, controls, estimates from batches.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/propagation/batch_estimates.h"
#include "core/propagation/first_order.h"
#include "core/propagation/linear_distribution.h"
#include "core/propagation/monte_carlo.h"

namespace covaria::detail {

/// Trials in a batch of a run of so many: some hundred batches or more, but enough trials in each for its
/// interval ends; a power of two for Sobol points.
std::uint64_t batch_of_run(const EvaluationOptions& options);

/// Variance reduction of one run. Used in this order: `source` for the pilot, `choose` after it, `source` for
/// the run, `estimates` in it, `apply` after it.
class ReducedRun {
public:
    /// `source`: of plain trials. All must outlive it.
    ReducedRun(const TrialSource& source, const InputSet& inputs, const Correlations& correlations,
               const LawOfPropagation& law, const EvaluationOptions& options);

    const TrialSource& source() const { return source_; }
    /// Keeps the controls that are worth their time, and finds what is known of them. Error: cancelled.
    Result<void> choose(Pilot& pilot, RunMonitor& monitor);
    BatchEstimates* estimates() { return estimates_ ? &*estimates_ : nullptr; }
    /// Puts the better estimates in, with their standard errors.
    void apply(const MonteCarloRun& run, std::vector<MonteCarloOutput>& outputs) const;
    /// Covariance of the outputs, scaled to their standard uncertainties.
    OutputCovariance covariance(const MonteCarloRun& run, const std::vector<MonteCarloOutput>& outputs) const;
    /// "X, Y (reason)" for each reason why outputs have no control.
    std::vector<Message> without_control() const;

private:
    void offer_controls();
    Eigen::Index output_of(Eigen::Index linear_part) const {
        return static_cast<Eigen::Index>((*rows_)[static_cast<std::size_t>(linear_part)].output);
    }
    /// Control by the linear part in row k; NaN where a figure is not known.
    BatchEstimates::Control control_of(std::size_t k) const;
    bool is_plain(const MonteCarloRun& run) const;
    BatchEstimates::Estimate figure_of(std::size_t output, std::size_t figure) const;
    double plain_gain(const MonteCarloOutput& output, const MonteCarloRun& run, std::size_t figure,
                      double error) const;

    const InputSet& inputs_;
    const Correlations& correlations_;
    const LawOfPropagation& law_;
    const EvaluationOptions& options_;
    TrialSource source_;
    std::optional<DrawPlan> sobol_plan_;
    std::optional<LinearRows> rows_;
    std::vector<std::vector<LinearTerm>> terms_;  ///< terms of each row
    OutputCovariance linear_covariance_;          ///< exact, of the linear parts of all outputs
    std::vector<Message> plain_because_;          ///< reasons by output; empty: controlled
    std::optional<BatchEstimates> estimates_;
};

}  // namespace covaria::detail
