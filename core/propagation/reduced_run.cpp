// Control variates and Sobol points in one run.
#include "core/propagation/reduced_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/name.h"
#include "core/propagation/adaptive.h"
#include "core/propagation/linear_parts.h"
#include "core/propagation/parallel_blocks.h"
#include "core/text/numbers.h"

namespace covaria::detail {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
/// Less, and a control does not repay its time.
constexpr double least_worthwhile_gain = 1.5;

double gain_of(double explained) {
    return 1.0 / (1.0 - std::min(explained, 1.0));
}

Message little_gained(double explained) {
    return tell<"the linear part explains %1 % of the variance: a gain of %2">(
        Message::number(format_decimals(100.0 * explained, 0)),
        Message::number(format_short(gain_of(explained), 2)));
}

/// Otherwise the scatter of the figure between batches tells nothing. Ends of intervals always have one.
bool has_variance(std::size_t figure, double degrees_of_freedom) {
    if (figure == 0) return mean_settles(degrees_of_freedom);
    return figure != 1 || uncertainty_settles(degrees_of_freedom);
}

std::uint64_t round_down(std::uint64_t trials) {
    std::uint64_t power = 1;
    while (power * 10 <= trials) power *= 10;
    return trials / power >= 5 ? 5 * power : trials / power >= 2 ? 2 * power : power;
}

std::uint64_t power_of_two_below(std::uint64_t trials) {
    std::uint64_t power = 1;
    while (power * 2 <= trials) power *= 2;
    return power;
}

}  // namespace

std::uint64_t batch_of_run(const EvaluationOptions& options) {
    constexpr std::uint64_t batches_of_points = 32, most = 100'000;
    if (options.method == Method::adaptive)
        return AdaptiveProcedure::batch_trials(options.coverage_probability);
    const double least = std::ceil(10.0 / (1.0 - options.coverage_probability) * (1.0 - 1e-12));
    const auto enough = std::max<std::uint64_t>(block_trials, static_cast<std::uint64_t>(least));
    if (options.variance_reduction == VarianceReduction::sobol)
        return std::max(power_of_two_below(std::min(options.trials / batches_of_points, most)),
                        2 * power_of_two_below(enough - 1));
    const std::uint64_t whole_blocks = (enough + block_trials - 1) / block_trials * block_trials;
    // Small batches gain more at the interval ends: the same trial is more often the end of the output and of
    // its control. But their bias falls with their size, and the standard error with the root of all trials.
    const auto unbiased = static_cast<std::uint64_t>(4.0 * std::sqrt(static_cast<double>(options.trials)));
    return std::max(round_down(std::min(unbiased, most)), whole_blocks);
}

ReducedRun::ReducedRun(const TrialSource& source, const InputSet& inputs, const Correlations& correlations,
                       const LawOfPropagation& law, const EvaluationOptions& options)
    : inputs_(inputs),
      correlations_(correlations),
      law_(law),
      options_(options),
      source_(source),
      plain_because_(source.outputs(),
                     law.condensed ? tell<"it has too many components for a linear part">() : Message()) {
    if (options.variance_reduction == VarianceReduction::sobol) {
        sobol_plan_ = *source.plan;
        sobol_plan_->use(std::make_shared<SobolPoints>(
            options.seed, inputs.components.size(), inputs.variance_estimates.size(), batch_of_run(options)));
        source_.plan = &*sobol_plan_;
    } else if (!law.condensed) {
        offer_controls();
    }
}

void ReducedRun::offer_controls() {
    LinearTermMaker maker(inputs_, correlations_);
    std::vector<LinearRow> rows;
    for (std::size_t j = 0; j < source_.outputs(); ++j) {
        auto terms = maker.make(law_.terms[j]);
        if (!terms) {
            plain_because_[j] = terms.error().message;
            continue;
        }
        LinearRow row{j, {}};
        for (const Sensitivity& s : law_.sensitivities[j])
            row.terms.push_back({s.input, s.coefficient, law_.inputs(static_cast<Eigen::Index>(s.input))});
        rows.push_back(std::move(row));
        terms_.push_back(std::move(*terms));
    }
    if (rows.empty()) return;
    rows_.emplace(std::move(rows));
    source_.linear = &*rows_;
}

Result<void> ReducedRun::choose(Pilot& pilot, RunMonitor& monitor) {
    std::vector<LinearRow> rows;
    std::vector<std::vector<LinearTerm>> terms;
    std::vector<bool> dropped;
    for (std::size_t k = 0; rows_ && k < rows_->size(); ++k) {
        const double explained = std::isfinite(pilot.explained[k]) ? pilot.explained[k] : 0.0;
        dropped.push_back(gain_of(explained) < least_worthwhile_gain);
        if (dropped.back()) {
            plain_because_[(*rows_)[k].output] = little_gained(explained);
            continue;
        }
        rows.push_back((*rows_)[k]);
        terms.push_back(std::move(terms_[k]));
    }
    pilot.drop_linear_parts(dropped);
    terms_ = std::move(terms);
    rows_.reset();
    source_.linear = nullptr;
    std::vector<BatchEstimates::Control> controls(rows.size());
    if (!rows.empty()) {
        rows_.emplace(std::move(rows));
        source_.linear = &*rows_;
        linear_covariance_ = covariance_of_draws(inputs_, correlations_, law_);
    }
    const WorkEnd end =
        run_each(controls.size(), monitor, [&](std::uint64_t k) { controls[k] = control_of(k); });
    if (end == WorkEnd::cancelled) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    estimates_.emplace(source_.outputs(), controls);
    return {};
}

BatchEstimates::Control ReducedRun::control_of(std::size_t k) const {
    const auto j = static_cast<Eigen::Index>((*rows_)[k].output);
    const LinearDistribution distribution(terms_[k]);
    const double lower = 0.5 * (1.0 - options_.coverage_probability);
    const double variance = linear_covariance_(j, j);
    const auto low = distribution.known_quantile(lower), high = distribution.known_quantile(1.0 - lower);
    BatchEstimates::Control control{(*rows_)[k].output};
    control.expectation = {distribution.has_mean() ? 0.0 : not_known,
                           std::isfinite(variance) ? variance : not_known, low ? low->value : not_known,
                           high ? high->value : not_known};
    control.error = {0.0, 0.0, low ? low->error : 0.0, high ? high->error : 0.0};
    return control;
}

/// Whether plain results have to be taken: where trials are lost, those that are left have another linear
/// part than the one whose distribution is known.
bool ReducedRun::is_plain(const MonteCarloRun& run) const {
    return run.failed() > 0 && options_.variance_reduction == VarianceReduction::control_variate;
}

/// Estimate of a figure, with the standard uncertainty instead of the variance.
BatchEstimates::Estimate ReducedRun::figure_of(std::size_t output, std::size_t figure) const {
    BatchEstimates::Estimate estimate = estimates_->estimate(output, figure);
    if (figure != 1) return estimate;
    estimate.value = std::sqrt(std::max(0.0, estimate.value));
    estimate.standard_error /= 2.0 * estimate.value;
    return estimate;
}

/// Variance of plain trials by theory (the fourth moment, the density at the end of the interval) over the
/// square of `error`.
double ReducedRun::plain_gain(const MonteCarloOutput& output, const MonteCarloRun& run, std::size_t figure,
                              double error) const {
    const auto n = static_cast<double>(run.moments.count());
    if (figure == 0) return std::pow(output.standard_error_of_mean / error, 2);
    if (figure == 1) return std::pow(output.standard_error_of_uncertainty / error, 2);
    const double q = 0.5 * (1.0 - options_.coverage_probability);
    const double end = figure == 2 ? output.symmetric.low : output.symmetric.high;
    const double width = 0.025 * (output.symmetric.high - output.symmetric.low);  // u may be infinite
    const double density = output.distribution.inside(end - width, end + width) / (2.0 * width);
    return q * (1.0 - q) / (n * density * density * error * error);
}

void ReducedRun::apply(const MonteCarloRun& run, std::vector<MonteCarloOutput>& outputs) const {
    const bool points = options_.variance_reduction == VarianceReduction::sobol;
    const std::vector<double> least = least_degrees_of_freedom(inputs_, law_);
    for (std::size_t j = 0; j < outputs.size(); ++j) {
        MonteCarloOutput& output = outputs[j];
        ReducedVariance reduced;
        reduced.plain_because = is_plain(run) ? "trials without a value" : plain_because_[j].english();
        const std::array<double*, 4> values{&output.mean, &output.standard_uncertainty, &output.symmetric.low,
                                            &output.symmetric.high};
        OutputFigures &e = reduced.standard_errors, &g = reduced.gains;
        const std::array<double*, 4> errors{&e.mean, &e.standard_uncertainty, &e.low, &e.high};
        const std::array<double*, 4> gains{&g.mean, &g.standard_uncertainty, &g.low, &g.high};
        const MonteCarloOutput plain = points ? output : MonteCarloOutput{};
        for (std::size_t f = 0; f < BatchFigures::count; ++f) {
            const auto estimate = figure_of(j, f);
            *errors[f] = estimate.standard_error;
            *gains[f] = points ? plain_gain(plain, run, f, estimate.standard_error) : estimate.gain;
            if (estimate.controlled) *values[f] = estimate.value;
            const double of_output = source_.model->outputs()[j].periodic ? infinity : least[j];
            const bool heavy = f == 1 && std::isnan(output.standard_error_of_uncertainty);
            if (heavy || !has_variance(f, of_output)) *errors[f] = *gains[f] = not_known;
            // A gain is stated of a result line, which has an infinite u here.
            if (!mean_settles(of_output)) *gains[f] = not_known;
        }
        output.standard_error_of_mean = e.mean;
        output.standard_error_of_uncertainty = e.standard_uncertainty;
        output.reduced = std::move(reduced);
    }
}

OutputCovariance ReducedRun::covariance(const MonteCarloRun& run,
                                        const std::vector<MonteCarloOutput>& outputs) const {
    OutputCovariance covariance = run.moments.covariance();
    if (!rows_ || is_plain(run)) return covariance;
    const OutputCovariance of_linear = run.moments.covariance_of_linear_parts();
    std::vector<double> slope(rows_->size());
    for (std::size_t k = 0; k < slope.size(); ++k)
        slope[k] = estimates_->estimate((*rows_)[k].output, 0).slope;
    const OutputBlocks& blocks = covariance.blocks();
    for (const OutputBlocks::Block& linear : of_linear.blocks().list()) {
        const std::size_t own = blocks.block_of(output_of(linear.first));
        const Eigen::Index first = blocks.list()[own].first;
        for (Eigen::Index a = linear.first; a < linear.first + linear.size; ++a)
            for (Eigen::Index b = linear.first; b < linear.first + linear.size; ++b) {
                const Eigen::Index i = output_of(a), j = output_of(b);
                const double known = linear_covariance_(i, j) - of_linear(a, b);
                if (std::isfinite(known))
                    covariance.block(own)(i - first, j - first) +=
                        slope[static_cast<std::size_t>(a)] * slope[static_cast<std::size_t>(b)] * known;
            }
    }
    // The same standard uncertainties as on the result lines.
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(covariance.rows());
    for (Eigen::Index j = 0; j < factor.size(); ++j)
        if (covariance(j, j) > 0.0)
            factor(j) =
                outputs[static_cast<std::size_t>(j)].standard_uncertainty / std::sqrt(covariance(j, j));
    for (std::size_t k = 0; k < blocks.list().size(); ++k) {
        const Eigen::VectorXd own = factor.segment(blocks.list()[k].first, blocks.list()[k].size);
        covariance.block(k) = Eigen::MatrixXd(own.asDiagonal() * covariance.block(k) * own.asDiagonal());
    }
    return covariance;
}

std::vector<Message> ReducedRun::without_control() const {
    std::map<std::string, std::pair<Message, Message>> outputs;  // by reason: its words, the outputs
    for (std::size_t j = 0; j < plain_because_.size(); ++j) {
        if (plain_because_[j].empty()) continue;
        auto& [reason, list] = outputs[plain_because_[j].english()];
        reason = plain_because_[j];
        const OutputQuantity& output = source_.model->outputs()[j];
        if (!list.empty()) list += ", ";
        list += output.group.empty() ? Message(output.symbol)
                                     : tell<"%1 of %2">(output.symbol, said_name(output.group));
    }
    std::vector<Message> words;
    for (const auto& [key, of] : outputs) words.push_back(of.second + " (" + of.first + ")");
    return words;
}

}  // namespace covaria::detail
