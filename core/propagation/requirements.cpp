#include "core/propagation/requirements.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/math/normal_quantile.h"
#include "core/propagation/evaluation.h"
#include "core/propagation/parallel_blocks.h"
#include "core/propagation/trial_block_runner.h"

namespace covaria {

namespace {

using detail::block_trials;

constexpr std::uint64_t most_trials = 1'000'000;
constexpr int pieces = 400;  ///< of an interval of integration

bool has_limits(const OutputRequirement& r) {
    return r.lower_limit || r.upper_limit;
}

ToleranceLimits limits_of(const OutputRequirement& r, double guard_band) {
    ToleranceLimits limits;
    limits.lower = r.lower_limit.value_or(-infinity);
    limits.upper = r.upper_limit.value_or(infinity);
    limits.accept_lower = limits.lower + guard_band;
    limits.accept_upper = limits.upper - guard_band;
    return limits;
}

/// Phi((high - x)/u) - Phi((low - x)/u); a step where u is zero.
double probability_inside(double x, double u, double low, double high) {
    if (!(u > 0.0)) return x >= low && x <= high ? 1.0 : 0.0;
    const auto below = [&](double limit) {
        return std::isinf(limit) ? (limit > 0.0 ? 1.0 : 0.0) : normal_distribution_function((limit - x) / u);
    };
    return std::max(0.0, below(high) - below(low));
}

/// Gauss' rule of two points in equal pieces: the ends, where a decision changes, are not asked for.
double integral(const std::function<double(double)>& f, double from, double to) {
    const double half = 0.5 * (to - from) / pieces, offset = half / std::sqrt(3.0);
    double sum = 0.0;
    for (int i = 0; to > from && i < pieces; ++i) {
        const double middle = from + (2 * i + 1) * half;
        sum += f(middle - offset) + f(middle + offset);
    }
    return sum * half;
}

/// Trials inside the tolerance of each requirement, over all valid ones.
class InsideCount {
public:
    InsideCount(const std::vector<OutputRequirement>& requirements)
        : requirements_(requirements), inside_(requirements.size(), 0) {}

    void add(const detail::TrialBlockRunner& runner) {
        valid_ += runner.valid();
        for (std::size_t r = 0; r < requirements_.size(); ++r) {
            const double low = requirements_[r].lower_limit.value_or(-infinity);
            const double high = requirements_[r].upper_limit.value_or(infinity);
            const double* y = runner.output(requirements_[r].output);
            for (std::size_t t = 0; t < runner.valid(); ++t)
                inside_[r] += y[t] >= low && y[t] <= high ? 1 : 0;
        }
    }
    void merge(const InsideCount& other) {
        valid_ += other.valid_;
        for (std::size_t r = 0; r < inside_.size(); ++r) inside_[r] += other.inside_[r];
    }
    double share(std::size_t r) const {
        return valid_ == 0 ? 0.0 : static_cast<double>(inside_[r]) / static_cast<double>(valid_);
    }

private:
    const std::vector<OutputRequirement>& requirements_;
    std::uint64_t valid_ = 0;
    std::vector<std::uint64_t> inside_;
};

Result<InsideCount> count_inside(const MeasurementModel& model, const UncertaintyResult& result,
                                 const std::vector<OutputRequirement>& requirements,
                                 const RunControl& control) {
    using namespace detail;
    const auto correlations = checked_correlations(model, result.inputs);
    if (!correlations) return fail(correlations.error());
    const auto law = law_of_propagation(model, result.inputs, *correlations);
    if (!law) return fail(law.error());
    const DrawPlan plan(result.inputs, *correlations);
    const TrialSource source{&model, &plan, result.provenance.seed, law->estimate};
    const std::uint64_t trials = std::min(result.trials, most_trials);
    const std::uint64_t units = (trials + unit_trials - 1) / unit_trials;
    std::vector<InsideCount> counts(units, InsideCount(requirements));
    const RunControl quiet{control.stop, {}, control.threads};
    RunMonitor monitor(quiet, 0);
    const WorkEnd end = run_each(units, monitor, [&](std::uint64_t unit) {
        TrialBlockRunner runner(source);
        const std::uint64_t last = std::min((unit + 1) * unit_trials, trials);
        for (std::uint64_t first = unit * unit_trials; first < last; first += block_trials) {
            runner.run(first, static_cast<std::size_t>(std::min<std::uint64_t>(block_trials, last - first)));
            counts[unit].add(runner);
        }
    });
    if (end == WorkEnd::cancelled) return fail(ErrorCode::cancelled, "the evaluation was stopped");
    InsideCount all(requirements);
    for (const InsideCount& count : counts) all.merge(count);
    return all;
}

void judge_target(RequirementResult& made, const OutputRequirement& r, const UncertaintyResult& result) {
    if (!r.target_uncertainty) return;
    const OutputResult& output = result.outputs[r.output];
    made.target_uncertainty = r.target_uncertainty;
    made.meets_target = output.expanded_uncertainty <= *r.target_uncertainty;
    if (made.meets_target || !(output.expanded_uncertainty > 0.0)) return;
    // The law of propagation says by which part u has to fall.
    const double part = *r.target_uncertainty / output.expanded_uncertainty;
    made.reductions = reductions(result, r.output, part * output.first_order.standard_uncertainty);
}

void judge_conformity(RequirementResult& made, const OutputRequirement& r, const UncertaintyResult& result) {
    if (!has_limits(r)) return;
    const OutputResult& output = result.outputs[r.output];
    const double y = output.estimate, u = output.standard_uncertainty;
    made.lower_limit = r.lower_limit;
    made.upper_limit = r.upper_limit;
    made.guard_band = r.guard_factor * output.expanded_uncertainty;
    const ToleranceLimits limits = limits_of(r, made.guard_band);
    made.decision = y >= limits.accept_lower && y <= limits.accept_upper
                        ? RequirementResult::Decision::accept
                        : RequirementResult::Decision::reject;
    made.conformance_normal = probability_inside(y, u, limits.lower, limits.upper);
    if (r.lower_limit && r.upper_limit && u > 0.0)
        made.capability_index = (*r.upper_limit - *r.lower_limit) / (4.0 * u);
    if (r.prior_mean && r.prior_standard_deviation)
        made.global_risks = global_risks(limits, *r.prior_mean, *r.prior_standard_deviation, u);
}

}  // namespace

std::vector<RequirementResult::Reduction> reductions(const UncertaintyResult& result, std::size_t output,
                                                     double wanted) {
    const double variance = std::pow(result.outputs[output].first_order.standard_uncertainty, 2);
    std::vector<RequirementResult::Reduction> found;
    for (const BudgetRow& row : result.budget.rows[output]) {
        const BudgetComponent& component = result.budget.components[row.component];
        if (!(row.contribution > 0.0) || component.held) continue;
        // With its u times s: u^2(y) = rest + 2 mixed s + own s^2, where mixed comes from its correlations.
        const double own = row.contribution * row.contribution;
        const double mixed = row.share * variance - own;
        const double rest = variance - own - 2.0 * mixed;
        const double inside = mixed * mixed - own * (rest - wanted * wanted);
        RequirementResult::Reduction reduction{row.component, component.standard_uncertainty, std::nullopt};
        const double s = inside >= 0.0 ? (-mixed + std::sqrt(inside)) / own : -1.0;
        if (s >= 0.0 && s < 1.0) reduction.needed = s * component.standard_uncertainty;
        found.push_back(reduction);
    }
    return found;
}

RequirementResult::GlobalRisks global_risks(const ToleranceLimits& limits, double prior_mean,
                                            double prior_standard_deviation, double u) {
    constexpr double reach = 9.0;  // standard deviations, beyond which nothing is left
    const double from = prior_mean - reach * prior_standard_deviation;
    const double to = prior_mean + reach * prior_standard_deviation;
    std::vector<double> points{from, to};
    for (const double edge : {limits.lower, limits.upper}) points.push_back(edge);
    for (const double edge : {limits.accept_lower, limits.accept_upper})
        for (const double distance : {-reach, -2.0, 2.0, reach}) points.push_back(edge + distance * u);
    for (double& point : points) point = std::clamp(point, from, to);
    std::sort(points.begin(), points.end());
    const auto density = [&](double x) {
        return normal_density((x - prior_mean) / prior_standard_deviation) / prior_standard_deviation;
    };
    const auto accepted = [&](double x) {
        return probability_inside(x, u, limits.accept_lower, limits.accept_upper);
    };
    RequirementResult::GlobalRisks risks;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double middle = 0.5 * (points[i] + points[i + 1]);
        if (middle >= limits.lower && middle <= limits.upper)
            risks.producer += integral([&](double x) { return density(x) * (1.0 - accepted(x)); }, points[i],
                                       points[i + 1]);
        else
            risks.consumer +=
                integral([&](double x) { return density(x) * accepted(x); }, points[i], points[i + 1]);
    }
    return risks;
}

Result<std::vector<RequirementResult>> check_requirements(const MeasurementModel& model,
                                                          const UncertaintyResult& result,
                                                          const std::vector<OutputRequirement>& requirements,
                                                          const RunControl& control) {
    std::vector<RequirementResult> all;
    for (const OutputRequirement& r : requirements) {
        RequirementResult made{r.output};
        judge_target(made, r, result);
        judge_conformity(made, r, result);
        all.push_back(std::move(made));
    }
    if (result.trials == 0 || std::none_of(requirements.begin(), requirements.end(), has_limits)) return all;
    const auto counts = count_inside(model, result, requirements, control);
    if (!counts) return fail(counts.error());
    for (std::size_t i = 0; i < all.size(); ++i)
        if (has_limits(requirements[i])) all[i].conformance_monte_carlo = counts->share(i);
    return all;
}

}  // namespace covaria
