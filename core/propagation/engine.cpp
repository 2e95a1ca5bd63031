// The engine put together: checks, law of propagation, Monte Carlo, and what is derived from both.
#include "core/propagation/engine.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "core/base/name.h"
#include "core/propagation/adaptive.h"
#include "core/propagation/contributions.h"
#include "core/propagation/coverage_regions.h"
#include "core/propagation/engine_parts.h"
#include "core/propagation/kinks.h"
#include "core/propagation/monte_carlo.h"
#include "core/propagation/propagated.h"
#include "core/propagation/reduced_run.h"
#include "core/propagation/second_order.h"
#include "core/propagation/sobol.h"
#include "core/propagation/take_trials.h"
#include "core/propagation/validation.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"

namespace covaria::detail {
namespace {

Result<void> check_options(const EvaluationOptions& options) {
    Problems problems;
    options.check(problems);
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error)
            return fail(ErrorCode::bad_input, problem.message, problem.path);
    return {};
}

std::uint64_t planned_trials(const EvaluationOptions& options) {
    return options.method == Method::monte_carlo ? options.trials : 0;
}

bool has_trials(const EvaluationOptions& options) {
    return options.method != Method::first_order || options.one_at_a_time_trials > 0 ||
           options.sobol_trials > 0 || options.contributor_trials > 0;
}

std::string in_a_row(const std::vector<std::string>& symbols) {
    std::string text;
    for (const std::string& symbol : symbols) text += (text.empty() ? "" : ", ") + symbol;
    return text;
}

Message in_a_row(const std::vector<Message>& names) {
    Message text;
    for (const Message& name : names) text += (text.empty() ? Message() : Message(", ")) + name;
    return text;
}

Message symbol_in_group(const OutputQuantity& output) {
    return output.group.empty() ? Message(output.symbol)
                                : tell<"%1 of %2">(output.symbol, said_name(output.group));
}

RunSize size_of_run(const EvaluationOptions& options) {
    const bool in_batches =
        options.method == Method::adaptive || options.variance_reduction != VarianceReduction::none;
    const std::uint64_t unit = in_batches ? batch_of_run(options) : unit_trials;
    if (options.method == Method::monte_carlo) return {options.trials, unit};
    return {options.maximum_trials / unit * unit, unit};
}

/// The model, inputs and law of propagation that are evaluated.
struct Subject {
    const MeasurementModel& model;
    SharedInputs inputs;
    const Propagation& propagation;
};

/// Double numbers are steps apart. Trials that spread over few of them state the steps, not the measurand.
void warn_about_steps(UncertaintyResult& result) {
    constexpr double few = 16.0;
    std::vector<const OutputQuantity*> rounded;
    for (const OutputResult& output : result.outputs) {
        const double y = std::abs(output.estimate), step = std::nextafter(y, infinity) - y;
        const double u = output.first_order.standard_uncertainty;
        if (u > 0.0 && u < few * step) rounded.push_back(&output.quantity);
    }
    if (rounded.empty()) return;
    const OutputQuantity& first = *rounded.front();
    result.warnings.push_back(
        tell<"u of %1 is a few of the steps in which numbers of its size are kept, so that its trials are "
             "rounded and their U is too large (results like this: %2). The law of propagation is not; or "
             "evaluate the deviation from a nominal value.">(
            first.group.empty() ? first.symbol : first.group + ": " + first.symbol, rounded.size()));
}

/// An evaluation: what its steps share.
class Evaluation {
public:
    Evaluation(const Subject& subject, const EvaluationOptions& options, const RunControl& control,
               const EngineSettings& settings)
        : model_(subject.model),
          inputs_(subject.inputs),
          correlations_(subject.propagation.correlations),
          law_(subject.propagation.law),
          options_(options),
          control_(control),
          settings_(settings),
          monitor_(control, planned_trials(options)) {}

    Result<UncertaintyResult> run();

private:
    RunContext context() { return {source_, options_.coverage_probability, settings_, monitor_}; }
    /// Context of the trials of the run, where variance reduction has other points or controls for them.
    RunContext context_of_run() {
        return {reduced_ ? reduced_->source() : source_, options_.coverage_probability, settings_, monitor_};
    }
    void warn_about_derivatives();
    void withdraw_first_order(std::size_t j);
    Result<void> add_contributions();
    Result<void> add_second_order();
    Result<void> add_monte_carlo();
    Result<Pilot> pilot_of_run();
    Result<MonteCarloRun> trials_of_run();
    std::unique_ptr<AdaptiveProcedure> adaptive_procedure() const;
    void take_over(const MonteCarloRun& run, std::vector<MonteCarloOutput> outputs);
    void warn_about(const MonteCarloRun& run);
    void warn_about_few_trials(const MonteCarloRun& run);
    void warn_about_reduction(const MonteCarloRun& run);
    void warn_about_tails();
    Result<void> add_regions();

    const MeasurementModel& model_;
    const SharedInputs inputs_;
    const Correlations& correlations_;
    const LawOfPropagation& law_;
    const EvaluationOptions& options_;
    const RunControl& control_;
    const EngineSettings& settings_;
    RunMonitor monitor_;
    TrialSource source_;
    std::optional<ReducedRun> reduced_;
    UncertaintyResult result_;
};

Result<UncertaintyResult> Evaluation::run() {
    if (options_.method == Method::first_order && !law_.is_differentiable())
        return fail(without_sensitivities(model_, law_));
    auto result = first_order_result(model_, inputs_, options_, law_);
    if (!result) return fail(result.error());
    result_ = std::move(*result);
    warn_about_derivatives();
    if (options_.second_order)
        if (auto ok = add_second_order(); !ok) return fail(ok.error());

    std::optional<DrawPlan> plan;
    if (has_trials(options_)) plan.emplace(inputs_, correlations_);
    source_ = {&model_, plan ? &*plan : nullptr, options_.seed, law_.estimate};
    if (options_.method != Method::first_order)
        if (auto ok = add_monte_carlo(); !ok) return fail(ok.error());
    if (auto ok = add_contributions(); !ok) return fail(ok.error());
    return std::move(result_);
}

/// A sensitivity coefficient of one side of a kink is none: the trials know both.
void Evaluation::warn_about_derivatives() {
    std::vector<Message> without, bent, rounded;
    const DoubtfulCoefficients doubtful = doubtful_coefficients(model_, inputs_, law_);
    for (std::size_t j = 0; j < result_.outputs.size(); ++j) {
        const Message name = symbol_in_group(result_.outputs[j].quantity);
        if (!law_.differentiable[j]) without.push_back(name);
        if (doubtful.is_rounding[j]) rounded.push_back(name);
        if (doubtful.has_kink[j]) bent.push_back(name);
        if (doubtful.has_kink[j] && options_.method != Method::first_order) withdraw_first_order(j);
    }
    if (!without.empty())
        result_.warnings.push_back(
            tell<"Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at "
                 "the estimates of its input quantities.">(in_a_row(without)));
    if (!rounded.empty())
        result_.warnings.push_back(
            tell<"The figures of the set-up are too far apart in size for %1: the last digits of the "
                 "estimates "
                 "change its sensitivity coefficients by more than a tenth. Give coordinates from a place "
                 "nearby.">(in_a_row(rounded)));
    if (bent.empty()) return;
    if (options_.method == Method::first_order)
        result_.warnings.push_back(
            tell<"%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a "
                 "condition): the law of propagation takes the sensitivity coefficients of one side. Use "
                 "Monte Carlo.">(in_a_row(bent)));
    else
        result_.warnings.push_back(
            tell<
                "Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities "
                "(an absolute value, a maximum, a condition): the law of propagation would take the "
                "sensitivity coefficients of one side.">(in_a_row(bent)));
}

void Evaluation::withdraw_first_order(std::size_t j) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    FirstOrderOutput& first = result_.outputs[j].first_order;
    first.standard_uncertainty = first.expanded_uncertainty = none;
    first.effective_degrees_of_freedom = infinity;
    first.coverage_factor =
        options_.coverage_factor.value_or(coverage_factor_of(options_.coverage_probability, infinity));
    result_.budget.rows[j].clear();
    result_.covariance.set(static_cast<Eigen::Index>(j), none);
}

Result<void> Evaluation::add_contributions() {
    if (options_.one_at_a_time_trials > 0)
        if (auto ok = add_one_at_a_time(result_.budget, context(), inputs_, correlations_,
                                        options_.one_at_a_time_trials);
            !ok)
            return fail(ok.error());
    if (options_.sobol_trials > 0) {
        const auto factors = sobol_factors(inputs_, law_, correlations_);
        auto indices = sobol_indices(context(), inputs_, correlations_, factors, options_.sobol_trials);
        if (!indices) return fail(indices.error());
        result_.sobol = std::move(*indices);
        add_rows_of_interactions(result_.budget, result_.sobol);
        result_.sobol_trials = options_.sobol_trials;
    }
    result_.contributors = contributors_of(inputs_, law_, correlations_);
    if (options_.contributor_trials == 0 || result_.contributors.empty()) return {};
    result_.contributor_trials = options_.contributor_trials;
    return add_contributor_trials(result_.contributors, context(), inputs_, law_, correlations_,
                                  options_.contributor_trials);
}

Result<void> Evaluation::add_second_order() {
    if (!correlations_.empty()) {
        result_.warnings.push_back(
            tell<"Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent "
                 "components, and some of these are correlated.">());
        return {};
    }
    const auto terms = second_order_terms(model_, inputs_, law_, control_.stop);
    if (!terms && terms.error().code == ErrorCode::cancelled) return fail(terms.error());
    if (!terms) {
        result_.warnings.push_back(tell<"Second-order terms are left out: %1.">(terms.error().message));
        return {};
    }
    std::vector<Message> without_u;
    for (Eigen::Index j = 0; j < law_.estimate.size(); ++j) {
        if (!law_.differentiable[static_cast<std::size_t>(j)]) continue;
        FirstOrderOutput& output = result_.outputs[static_cast<std::size_t>(j)].first_order;
        const double variance = law_.covariance(j, j) + terms->variance(j);
        output.second_order_estimate_shift = terms->shift(j);
        if (variance >= 0.0)
            output.second_order_standard_uncertainty = std::sqrt(variance);
        else
            without_u.push_back(symbol_in_group(result_.outputs[static_cast<std::size_t>(j)].quantity));
    }
    if (!without_u.empty())
        result_.warnings.push_back(
            tell<"There is no standard uncertainty with second-order terms of %1: they would make its "
                 "variance negative, so terms of higher order matter as much. Use Monte Carlo.">(
                in_a_row(without_u)));
    return {};
}

std::unique_ptr<AdaptiveProcedure> Evaluation::adaptive_procedure() const {
    WatchedStatistics watched;
    watched.probability = options_.coverage_probability;
    for (std::size_t j = 0; j < model_.outputs().size(); ++j)
        if (model_.outputs()[j].role == OutputRole::measurand) watched.outputs.push_back(j);
    for (std::size_t j = 0; watched.outputs.empty() && j < model_.outputs().size(); ++j)
        watched.outputs.push_back(j);
    const std::vector<double> least = least_degrees_of_freedom(inputs_, law_);
    for (std::size_t j : watched.outputs) {
        watched.units.push_back(model_.outputs()[j].unit);
        watched.least_degrees_of_freedom.push_back(least[j]);
    }
    for (const CoverageRegion& region : result_.regions) {
        const bool whole_group = watched.regions.empty() || watched.regions.back().group != region.group;
        if (whole_group && !region.singular) watched.regions.push_back(region);
    }
    return std::make_unique<AdaptiveProcedure>(options_, std::move(watched));
}

Result<Pilot> Evaluation::pilot_of_run() {
    if (options_.variance_reduction != VarianceReduction::none)
        reduced_.emplace(source_, inputs_, correlations_, law_, options_);
    auto pilot = run_pilot(context_of_run(), size_of_run(options_).trials);
    if (pilot && reduced_)
        if (auto ok = reduced_->choose(*pilot, monitor_); !ok) return fail(ok.error());
    return pilot;
}

Result<MonteCarloRun> Evaluation::trials_of_run() {
    auto pilot = pilot_of_run();
    if (!pilot) return fail(pilot.error());
    const RunSize size = size_of_run(options_);
    BatchWatch watch{nullptr, reduced_ ? reduced_->estimates() : nullptr};
    if (options_.method == Method::monte_carlo)
        return run_monte_carlo(context_of_run(), std::move(*pilot), size, watch);
    const auto procedure = adaptive_procedure();
    procedure->judge_by(watch.estimates);
    watch.adaptive = procedure.get();
    result_.adaptive = true;
    auto run = run_monte_carlo(context_of_run(), std::move(*pilot), size, watch);
    if (run) result_.batches = run->units;
    result_.stabilised = procedure->stabilised();
    return run;
}

Result<void> Evaluation::add_monte_carlo() {
    auto run = trials_of_run();
    if (!run) return fail(run.error());
    auto outputs = outputs_of(*run, options_.coverage_probability, monitor_);
    if (!outputs) return fail(outputs.error());
    result_.covariance_before_trials = std::exchange(result_.covariance, run->moments.covariance());
    if (reduced_) {
        reduced_->apply(*run, *outputs);
        result_.covariance = reduced_->covariance(*run, *outputs);
        result_.variance_reduction = options_.variance_reduction;
    }
    take_over(*run, std::move(*outputs));
    warn_about(*run);
    if (reduced_) warn_about_reduction(*run);
    return add_regions();
}

void Evaluation::take_over(const MonteCarloRun& run, std::vector<MonteCarloOutput> outputs) {
    result_.trials = run.trials;
    result_.failed_trials = run.failed();
    result_.intervals_exact = run.exact;
    result_.convergence = run.convergence;
    const std::vector<double> least = least_degrees_of_freedom(inputs_, law_);
    for (std::size_t j = 0; j < outputs.size(); ++j) {
        OutputResult& output = result_.outputs[j];
        if (!std::isnan(output.first_order.standard_uncertainty))
            output.first_order.validation =
                validation_of(output.first_order, outputs[j].symmetric, options_.coverage_probability,
                              output.quantity.unit, options_.significant_digits, run.trials - run.failed());
        take_trials(output, std::move(outputs[j]), least[j], result_);
    }
}

void Evaluation::warn_about(const MonteCarloRun& run) {
    std::vector<Message>& warnings = result_.warnings;
    if (run.failed() > 0) {
        std::ostringstream percent;
        percent << 100.0 * static_cast<double>(run.failed()) / static_cast<double>(run.trials);
        Message warning = tell<
            "%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and "
            "are not part of the statistics.">(run.failed(), run.trials, percent.str());
        if (!represents_measurand(result_))
            warning +=
                " " + tell<
                          "The result does not represent the measurand: more than 1 % of the trials are "
                          "lost, and they are not a random choice.">();
        warnings.push_back(std::move(warning));
    }
    if (!result_.stabilised)
        warnings.push_back(tell<"The adaptive procedure stopped at %1 trials before its results were stable: "
                                "allow more trials, or ask for fewer significant digits.">(run.trials));
    warn_about_few_trials(run);
    if (!run.exact)
        warnings.push_back(tell<"Coverage intervals are interpolated in fine cells: there are too many "
                                "trials to keep the values of the tails in memory.">());
    if (source_.plan->largest_compromise() > 1e-3) {
        std::ostringstream compromise;
        compromise << std::setprecision(2) << source_.plan->largest_compromise();
        warnings.push_back(
            tell<"The correlations stated cannot all hold with these distributions: the nearest that can are "
                 "drawn, with coefficients that differ by up to %1.">(compromise.str()));
    }
    warn_about_tails();
    warn_about_steps(result_);
    for (const OutputResult& output : result_.outputs)
        if (output.quantity.periodic && output.standard_uncertainty > 1.0 &&
            output.first_order.standard_uncertainty <= 1.0)
            warnings.push_back(
                tell<"The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.">(
                    output.quantity.symbol,
                    (output.quantity.group.empty() ? "" : " (" + output.quantity.group + ")")));
}

/// 7.9.4 a) of JCGM 101 does not look at fewer trials than these at once.
void Evaluation::warn_about_few_trials(const MonteCarloRun& run) {
    const double outside = 1.0 - options_.coverage_probability;
    const auto trials = static_cast<double>(run.moments.count());
    if (trials >= std::max(1e4, 100.0 / outside * (1.0 - 1e-12))) return;
    result_.warnings.push_back(
        tell<
            "%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that "
            "U is not known well. JCGM 101 7.2.2 asks for some %4 trials.">(
            Message::number(format_decimals(trials, 0)),
            Message::number(format_short(100.0 * (1.0 - outside), 9)),
            Message::number(format_short(std::max(1.0, std::round(0.5 * outside * trials)), 3)),
            Message::number(format_decimals(std::round(1e4 / outside), 0))));
}

void Evaluation::warn_about_reduction(const MonteCarloRun& run) {
    std::vector<Message>& warnings = result_.warnings;
    const std::uint64_t batch = batch_of_run(options_);
    if (run.trials / batch < BatchEstimates::least_batches)
        warnings.push_back(
            tell<"Nothing is gained by variance reduction, and standard errors are not known: there are "
                 "fewer than %1 batches of %2 trials.">(BatchEstimates::least_batches, batch));
    else if (options_.variance_reduction == VarianceReduction::control_variate && run.failed() > 0)
        warnings.push_back(tell<"Control variates are not used: the linear part of the trials that have a "
                                "value has another distribution than that of all trials.">());
    else
        for (const Message& outputs : reduced_->without_control())
            warnings.push_back(tell<"Without control variate: %1.">(outputs));
}

/// Student t inputs whose variance, or the variance of whose squares, does not exist.
void Evaluation::warn_about_tails() {
    const std::vector<double> least = least_degrees_of_freedom(inputs_, law_);
    std::vector<std::string> without_u, unsettled;
    std::vector<Message> heavy;
    for (const OutputResult& output : result_.outputs)
        if (std::isfinite(output.standard_uncertainty) && output.standard_uncertainty > 0.0 &&
            !output.quantity.periodic && std::isnan(output.monte_carlo->standard_error_of_uncertainty) &&
            !(output.monte_carlo->reduced && std::isnan(output.monte_carlo->reduced->standard_errors.high)))
            heavy.push_back(symbol_in_group(output.quantity));
    for (std::size_t j = 0; j < least.size(); ++j) {
        if (!(least[j] <= 4.0) || result_.outputs[j].quantity.periodic) continue;
        std::vector<std::string>& list = least[j] <= 2.0 ? without_u : unsettled;
        const std::string& symbol = result_.outputs[j].quantity.symbol;
        if (std::find(list.begin(), list.end(), symbol) == list.end()) list.push_back(symbol);
    }
    for (std::size_t j = 0; j < least.size(); ++j)  // said below
        if (least[j] <= 4.0) std::erase(heavy, symbol_in_group(result_.outputs[j].quantity));
    if (!heavy.empty())
        result_.warnings.push_back(
            tell<"The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not "
                 "exist: the tails of its distribution are too heavy. Use the coverage interval.">(
                in_a_row(heavy)));
    if (!without_u.empty())
        result_.warnings.push_back(
            tell<"The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t "
                 "distribution with two degrees of freedom or fewer has no finite standard deviation: it is "
                 "shown as infinite, and U is half the width of the coverage interval.">(
                in_a_row(without_u)));
    if (!unsettled.empty() && result_.adaptive)
        result_.warnings.push_back(
            tell<"The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t "
                 "distributions with four degrees of freedom or fewer have no finite fourth moment: the "
                 "adaptive procedure judges by the coverage intervals; use these.">(in_a_row(unsettled)));
}

Result<void> Evaluation::add_regions() {
    Eigen::VectorXd mean(law_.estimate.size());
    for (Eigen::Index j = 0; j < mean.size(); ++j)
        mean(j) = result_.outputs[static_cast<std::size_t>(j)].monte_carlo->mean;
    for (CoverageRegion& region : result_.regions) {
        // Curvature can hide a rank deficiency of first order (Z = hypot(R, X)); an estimate at which the
        // sensitivity vanishes says nothing about it.
        bool first_order_known = true;
        for (std::size_t j : region.outputs)
            first_order_known = first_order_known && result_.outputs[j].first_order.standard_uncertainty > 0;
        region.singular = (first_order_known && is_singular(law_.covariance, region.outputs)) ||
                          is_singular(result_.covariance, region.outputs);
    }
    return fill_monte_carlo_factors(result_.regions, context_of_run(), mean, result_.covariance,
                                    result_.trials);
}

}  // namespace

Result<UncertaintyResult> evaluate_with(const MeasurementModel& model, const InputSet& inputs,
                                        const EvaluationOptions& options, const RunControl& control,
                                        const EngineSettings& settings) {
    if (auto ok = check_options(options); !ok) return fail(ok.error());
    const auto propagation = propagate(model, inputs);
    if (!propagation) return fail(propagation.error());
    return Evaluation({model, inputs, *propagation}, options, control, settings).run();
}

namespace {

EvaluationOptions without_trials(EvaluationOptions options) {
    options.method = Method::first_order;
    options.one_at_a_time_trials = 0;
    options.contributor_trials = 0;
    options.sobol_trials = 0;
    return options;
}

}  // namespace

}  // namespace covaria::detail

namespace covaria {

Result<UncertaintyResult> evaluate(const MeasurementModel& model, const InputSet& inputs,
                                   const EvaluationOptions& options, const RunControl& control) {
    return detail::evaluate_with(model, inputs, options, control, {});
}

Result<UncertaintyResult> evaluate(const PropagatedModel& model, const EvaluationOptions& options,
                                   const RunControl& control) {
    if (auto ok = detail::check_options(options); !ok) return fail(ok.error());
    const auto& propagation = model.propagation();
    if (!propagation) return fail(propagation.error());
    return detail::Evaluation({*model.model(), model.shared_inputs(), *propagation}, options, control, {})
        .run();
}

std::uint64_t units_of_run(const EvaluationOptions& options) {
    return options.method == Method::first_order ? 0 : detail::size_of_run(options).units();
}

Result<UncertaintyResult> evaluate_first_order(const MeasurementModel& model, const InputSet& inputs,
                                               const EvaluationOptions& options) {
    return evaluate(model, inputs, detail::without_trials(options));
}

Result<UncertaintyResult> evaluate_first_order(const PropagatedModel& model,
                                               const EvaluationOptions& options) {
    return evaluate(model, detail::without_trials(options));
}

}  // namespace covaria
