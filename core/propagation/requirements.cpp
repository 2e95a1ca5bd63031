#include "core/propagation/requirements.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"
#include "core/propagation/guard_band.h"
#include "core/result/representation.h"

namespace covaria {

namespace {

constexpr int pieces = 400;  ///< pieces of an interval of integration

using ConformanceBy = RequirementResult::Distribution;
using Decision = RequirementResult::Decision;

ToleranceLimits limits_of(const OutputRequirement& r, double guard_band) {
    const double lower = r.lower_limit.value_or(-infinity), upper = r.upper_limit.value_or(infinity);
    return {lower, upper, lower + guard_band, upper - guard_band};
}

/// F((high - x)/u) - F((low - x)/u) of Student's t, normal for infinite nu; a step where u is zero.
double probability_inside(double x, double u, double nu, double low, double high) {
    if (!(u > 0.0)) return x >= low && x <= high ? 1.0 : 0.0;
    const double below = t_distribution_function((low - x) / u, nu);
    const double above = t_distribution_function((x - high) / u, nu);
    return std::clamp(1.0 - below - above, 0.0, 1.0);
}

/// Probability between the limits by the distribution that the result line states.
double probability_inside(const OutputResult& output, double low, double high) {
    if (output.monte_carlo) return output.monte_carlo->distribution.inside(low, high);
    return probability_inside(output.estimate, output.standard_uncertainty,
                              output.first_order.effective_degrees_of_freedom, low, high);
}

/// An angle is the same after a full turn: two limits are moved by whole turns to where the estimate is.
ToleranceLimits at_branch_of(const OutputResult& output, ToleranceLimits limits) {
    const double turn = 2.0 * std::numbers::pi;
    const double middle = 0.5 * (limits.lower + limits.upper);
    if (!output.quantity.periodic || !std::isfinite(middle)) return limits;
    const double moved = turn * std::round((output.estimate - middle) / turn);
    for (double* limit : {&limits.lower, &limits.upper, &limits.accept_lower, &limits.accept_upper})
        *limit += moved;
    return limits;
}

/// Probability of conformity, with the neighbouring turns where an angle has both limits.
double conformance(const OutputResult& output, const ToleranceLimits& limits) {
    double p = probability_inside(output, limits.lower, limits.upper);
    const double width = limits.upper - limits.lower, turn = 2.0 * std::numbers::pi;
    if (!output.quantity.periodic || !std::isfinite(width)) return p;
    if (width >= turn) return 1.0;
    for (const double by : {-turn, turn})
        p += probability_inside(output, limits.lower + by, limits.upper + by);
    return std::min(p, 1.0);
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

ConformanceBy distribution_of(const OutputResult& output) {
    if (output.monte_carlo) return ConformanceBy::trials;
    return std::isfinite(output.first_order.effective_degrees_of_freedom) ? ConformanceBy::student_t
                                                                          : ConformanceBy::normal;
}

void judge_conformity(RequirementResult& made, const OutputResult& output) {
    const double y = output.estimate, u = output.standard_uncertainty;
    const auto nonconforming_at = [&](double value) {  // the tolerance moved instead of the distribution
        const double by = value - y;
        return 1.0 - conformance(output, {made.lower_limit.value_or(-infinity) - by,
                                          made.upper_limit.value_or(infinity) - by});
    };
    made.guard_band = guard_band_of(made, {output.expanded_uncertainty, u, nonconforming_at});
    const ToleranceLimits stated = limits_of(made, made.guard_band), limits = at_branch_of(output, stated);
    made.decision =
        y >= limits.accept_lower && y <= limits.accept_upper ? Decision::accept : Decision::reject;
    made.conformance = conformance(output, limits);
    made.conformance_by = distribution_of(output);
    if (made.lower_limit && made.upper_limit) {
        const double tolerance = *made.upper_limit - *made.lower_limit;
        if (u > 0.0 && std::isfinite(u)) made.capability_index = tolerance / (4.0 * u);
        if (output.expanded_uncertainty > 0.0)
            made.uncertainty_ratio = tolerance / (2.0 * output.expanded_uncertainty);
    }
    if (made.prior_mean && made.prior_standard_deviation && std::isfinite(u))
        made.global_risks = global_risks(stated, *made.prior_mean, *made.prior_standard_deviation, u);
}

}  // namespace

RequirementResult judge(const UncertaintyResult& result, const OutputRequirement& requirement) {
    const OutputResult& output = result.outputs[requirement.output];
    RequirementResult made{requirement};
    if (!represents_measurand(result)) {
        made.not_judged = why_not_judged();
        made.meets_target = false;
        return made;
    }
    if (made.target_uncertainty) made.meets_target = output.expanded_uncertainty <= *made.target_uncertainty;
    if (made.lower_limit || made.upper_limit) judge_conformity(made, output);
    return made;
}

bool is_met(const RequirementResult& verdict) {
    return verdict.not_judged.empty() && verdict.meets_target &&
           verdict.decision != RequirementResult::Decision::reject;
}

std::optional<bool> are_met(const std::vector<RequirementResult>& verdicts, std::size_t output) {
    std::optional<bool> met;
    for (const RequirementResult& verdict : verdicts)
        if (verdict.output == output) met = met.value_or(true) && is_met(verdict);
    return met;
}

std::vector<RequirementResult> judge(const UncertaintyResult& result,
                                     const std::vector<OutputRequirement>& requirements) {
    std::vector<RequirementResult> all;
    for (const OutputRequirement& r : requirements) all.push_back(judge(result, r));
    return all;
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
        return probability_inside(x, u, infinity, limits.accept_lower, limits.accept_upper);
    };
    RequirementResult::GlobalRisks risks;
    double both = 0.0, neither = 0.0;  // conforming and accepted; not conforming and rejected
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double middle = 0.5 * (points[i] + points[i + 1]);
        const bool conforms = middle >= limits.lower && middle <= limits.upper;
        const auto part = [&](bool is_accepted) {
            return integral(
                [&](double x) { return density(x) * (is_accepted ? accepted(x) : 1.0 - accepted(x)); },
                points[i], points[i + 1]);
        };
        (conforms ? both : risks.consumer) += part(true);
        (conforms ? risks.producer : neither) += part(false);
    }
    if (both + risks.consumer > 0.0) risks.consumer_if_accepted = risks.consumer / (both + risks.consumer);
    if (neither + risks.producer > 0.0)
        risks.producer_if_rejected = risks.producer / (neither + risks.producer);
    return risks;
}

}  // namespace covaria
