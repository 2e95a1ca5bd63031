// The law of propagation and the moments of Monte Carlo, for some outputs.
#include "core/propagation/evaluate_summary.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/propagation/adaptive.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/engine_parts.h"
#include "core/propagation/interval_collector.h"
#include "core/propagation/moments.h"
#include "core/propagation/summary_controls.h"
#include "core/propagation/take_trials.h"
#include "core/propagation/trial_block_runner.h"
#include "core/result/result_line.h"

namespace covaria {

namespace {

using namespace detail;

/// Maker of the result lines of the chosen outputs.
class SummaryMaker {
public:
    SummaryMaker(const MeasurementModel& model, const InputSet& inputs,
                 const std::vector<std::size_t>& outputs, const EvaluationOptions& options,
                 const LawOfPropagation& law)
        : inputs_(inputs), outputs_(outputs), options_(options), law_(law) {
        line_.coverage_probability = options.coverage_probability;
        line_.fixed_coverage_factor = options.coverage_factor;
        for (const std::size_t j : outputs)
            line_.outputs.push_back(
                output_result(model.outputs()[j], law, static_cast<Eigen::Index>(j), options));
        covariance_ = law.covariance.is_whole() || law.condensed ? law.covariance.among(outputs)
                                                                 : covariance_among(law, outputs);
    }

    /// False: stopped.
    Result<bool> add_trials(TrialSource source, const Correlations& correlations,
                            const std::function<bool(std::uint64_t)>& advance) {
        if (options_.variance_reduction == VarianceReduction::control_variate)
            controls_.emplace(inputs_, correlations, law_, outputs_);
        const std::size_t rows = outputs_.size() + (controls_ ? controls_->rows().size() : 0);
        if (rows > outputs_.size()) source.linear = &controls_->rows();
        Moments moments(shift(rows));
        const std::size_t bytes = EngineSettings{}.tail_bytes / std::max<std::size_t>(1, rows);
        std::vector<IntervalCollector> collectors(rows,
                                                  IntervalCollector(options_.coverage_probability, bytes));
        if (!run(source, &moments, collectors, advance)) return false;
        if (moments.count() < 2) return fail(ErrorCode::numeric, tell<"no trial has a value">());
        std::vector<std::optional<CoverageInterval>> intervals(rows);
        const auto take = [&] {
            for (std::size_t k = 0; k < collectors.size(); ++k)
                if (!intervals[k]) intervals[k] = collectors[k].interval();
        };
        take();
        if (std::find(intervals.begin(), intervals.end(), std::nullopt) != intervals.end()) {
            if (!run(source, nullptr, collectors, advance)) return false;
            take();
        }
        failed_trials_ = options_.trials - moments.count();
        line_.trials = options_.trials;
        TrialFigures figures{moments.means(), moments.covariance().whole(), {}};
        for (const auto& interval : intervals) figures.intervals.push_back(*interval);
        // The linear part of the trials that have a value has another distribution than that of all trials.
        if (controls_ && failed_trials_ == 0)
            controls_->improve(figures, options_.coverage_probability, options_.trials);
        take_figures(figures);
        return true;
    }

    void take_figures(const TrialFigures& figures) {
        const Eigen::Index own = covariance_.rows();
        covariance_ = figures.covariance.topLeftCorner(own, own);
        const std::vector<double> least = least_degrees_of_freedom(inputs_, law_);
        for (std::size_t k = 0; k < outputs_.size(); ++k) {
            const auto index = static_cast<Eigen::Index>(k);
            MonteCarloOutput trials;
            trials.mean = figures.mean(index);
            trials.standard_uncertainty = std::sqrt(std::max(0.0, covariance_(index, index)));
            trials.symmetric = figures.intervals[k];
            OutputResult& output = line_.outputs[k];
            take_trials(output, std::move(trials), least[outputs_[k]], line_);
        }
    }

    EvaluationSummary take() {
        EvaluationSummary summary{estimates(), estimates(), estimates(), covariance_, failed_trials_};
        for (std::size_t k = 0; k < line_.outputs.size(); ++k) {
            OutputResult& output = line_.outputs[k];
            if (!output.monte_carlo) state_expanded_uncertainty(output, line_);
            const auto index = static_cast<Eigen::Index>(k);
            summary.standard_uncertainty(index) = output.standard_uncertainty;
            summary.expanded_uncertainty(index) = output.expanded_uncertainty;
        }
        return summary;
    }

private:
    Eigen::VectorXd estimates() const {
        Eigen::VectorXd y(static_cast<Eigen::Index>(line_.outputs.size()));
        for (Eigen::Index k = 0; k < y.size(); ++k)
            y(k) = line_.outputs[static_cast<std::size_t>(k)].estimate;
        return y;
    }

    /// Shift of the moments: estimates of the outputs, and 0 for linear parts, which are deviations.
    Eigen::VectorXd shift(std::size_t rows) const {
        Eigen::VectorXd shift = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows));
        shift.head(static_cast<Eigen::Index>(outputs_.size())) = estimates();
        return shift;
    }

    /// The trials in order; only the chosen outputs are looked at. `moments` null: tails once more.
    bool run(const TrialSource& source, Moments* moments, std::vector<IntervalCollector>& collectors,
             const std::function<bool(std::uint64_t)>& advance) const {
        TrialBlockRunner runner(source);
        TrialRows chosen(collectors.size()), scratch(collectors.size());
        const std::size_t first_linear = source.outputs();
        for (std::uint64_t first = 0; first < options_.trials; first += block_trials) {
            runner.run(first, std::min<std::uint64_t>(block_trials, options_.trials - first));
            for (std::size_t k = 0; k < collectors.size(); ++k) {
                const std::size_t row =
                    k < outputs_.size() ? outputs_[k] : first_linear + k - outputs_.size();
                std::copy_n(runner.output(row), padded_to_lanes(runner.valid()), chosen.row(k));
                collectors[k].add(chosen.row(k), runner.valid());
            }
            if (moments) moments->add(chosen.data(), runner.valid(), scratch);
            if (!advance(moments ? runner.trials() : 0)) return false;
        }
        return true;
    }

    const InputSet& inputs_;
    const std::vector<std::size_t>& outputs_;
    const EvaluationOptions& options_;
    const LawOfPropagation& law_;
    std::optional<SummaryControls> controls_;
    UncertaintyResult line_;
    Eigen::MatrixXd covariance_;
    std::uint64_t failed_trials_ = 0;
};

}  // namespace

Result<EvaluationSummary> evaluate_summary(const MeasurementModel& model, const InputSet& inputs,
                                           const std::vector<std::size_t>& outputs,
                                           const EvaluationOptions& options,
                                           const std::function<bool(std::uint64_t)>& advance) {
    const auto correlations = checked_correlations(model, inputs);
    if (!correlations) return fail(correlations.error());
    const auto law = law_of_propagation(model, inputs, *correlations);
    if (!law) return fail(law.error());
    if (options.method == Method::first_order &&
        !std::all_of(outputs.begin(), outputs.end(), [&](std::size_t j) { return law->differentiable[j]; }))
        return fail(without_sensitivities(model, *law));
    SummaryMaker maker(model, inputs, outputs, options, *law);
    bool finished = true;
    if (options.method == Method::first_order) {
        finished = advance(1);
    } else {
        const DrawPlan plan(inputs, *correlations);
        const auto added =
            maker.add_trials({&model, &plan, options.seed, law->estimate}, *correlations, advance);
        if (!added) return fail(added.error());
        finished = *added;
    }
    if (!finished) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    return maker.take();
}

}  // namespace covaria
