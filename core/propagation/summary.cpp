// The law of propagation and the moments of Monte Carlo, for some outputs.
#include "core/propagation/summary.h"

#include <algorithm>

#include "core/propagation/draw_plan.h"
#include "core/propagation/evaluation.h"
#include "core/propagation/moments.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria {

namespace {

using namespace detail;

EvaluationSummary first_order_of(const LawOfPropagation& law, const std::vector<std::size_t>& outputs,
                                 const EvaluationOptions& options) {
    const auto n = static_cast<Eigen::Index>(outputs.size());
    EvaluationSummary summary{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n),
                              Eigen::MatrixXd(n, n), 0};
    for (Eigen::Index a = 0; a < n; ++a) {
        const auto j = static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(a)]);
        summary.estimate(a) = law.estimate(j);
        summary.standard_uncertainty(a) = law.uncertainty(j);
        summary.coverage_factor(a) = options.coverage_factor.value_or(
            coverage_factor_of(options.coverage_probability, law.degrees_of_freedom(j)));
        for (Eigen::Index b = 0; b < n; ++b)
            summary.covariance(a, b) =
                law.covariance(j, static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(b)]));
    }
    return summary;
}

/// The trials of a run, in order; only the chosen outputs are summed up. False: stopped.
bool add_trials(const TrialSource& source, const std::vector<std::size_t>& outputs, std::uint64_t trials,
                Moments& moments, const std::function<bool(std::uint64_t)>& advance) {
    TrialBlockRunner runner(source);
    TrialRows chosen(outputs.size()), scratch(outputs.size());
    for (std::uint64_t first = 0; first < trials; first += block_trials) {
        runner.run(first, std::min<std::uint64_t>(block_trials, trials - first));
        for (std::size_t k = 0; k < outputs.size(); ++k)
            std::copy_n(runner.output(outputs[k]), padded_to_lanes(runner.valid()), chosen.row(k));
        moments.add(chosen.data(), runner.valid(), scratch);
        if (!advance(runner.trials())) return false;
    }
    return true;
}

}  // namespace

Result<EvaluationSummary> evaluate_summary(const MeasurementModel& model, const InputSet& inputs,
                                           const std::vector<std::size_t>& outputs,
                                           const EvaluationOptions& options,
                                           const std::function<bool(std::uint64_t)>& advance) {
    const auto correlations = checked_correlations(model, inputs);
    if (!correlations) return fail(correlations.error());
    const auto law = law_of_propagation(model, inputs, *correlations);
    if (!law) return fail(law.error());
    EvaluationSummary summary = first_order_of(*law, outputs, options);
    if (options.method == Method::first_order) {
        if (!advance(1)) return fail(ErrorCode::cancelled, "the evaluation was stopped");
        return summary;
    }
    const DrawPlan plan(inputs, *correlations);
    Moments moments(summary.estimate);
    if (!add_trials({&model, &plan, options.seed, law->estimate}, outputs, options.trials, moments, advance))
        return fail(ErrorCode::cancelled, "the evaluation was stopped");
    if (moments.count() < 2) return fail(ErrorCode::numeric, "no trial has a value");
    summary.failed_trials = options.trials - moments.count();
    summary.estimate = moments.means();
    summary.standard_uncertainty = moments.standard_uncertainties();
    summary.covariance = moments.covariance();
    return summary;
}

}  // namespace covaria
