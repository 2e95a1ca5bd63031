// Target uncertainties and the reverse budget, conformity and risks.
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/propagation/engine.h"
#include "core/propagation/requirements.h"
#include "core/propagation/reverse_budget.h"
#include "test_models.h"

namespace covaria::test::requirements_test {
namespace {

EvaluationOptions trials(std::uint64_t count) {
    EvaluationOptions options;
    options.trials = count;
    return options;
}

/// A sum of three, two of them correlated.
InputSet three() {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{10, 3}), infinity);
    add_quantity(inputs, "b", Distribution::of(Normal{0, 2}), infinity);
    add_quantity(inputs, "c", Distribution::of(Normal{0, 1}), infinity);
    inputs.correlations.push_back({0, 1, 0.4});
    return inputs;
}

/// The component's figure as a user would put it in: the same distribution, narrower.
InputSet with_figure(InputSet inputs, std::size_t component, double factor) {
    Distribution& distribution = inputs.components[component].distribution;
    const double mean = distribution.mean();
    distribution = distribution.shifted(-mean).scaled(factor).shifted(mean);
    return inputs;
}

void expect_targets_met(const MeasurementModel& model, const InputSet& inputs,
                        const EvaluationOptions& options, double part, double tolerance,
                        std::size_t expected_attainable) {
    const auto result = evaluate(model, inputs, options).value();
    const double target = part * result.outputs[0].expanded_uncertainty;
    const auto budget = reverse_budget(&model, result, 0, target).value();
    std::size_t attainable = 0;
    for (const auto& reduction : budget.reductions) {
        const InputSet changed = with_figure(inputs, reduction.component, reduction.factor().value_or(0.0));
        const double U = evaluate(model, changed, options)->outputs[0].expanded_uncertainty;
        if (reduction.needed) {
            ++attainable;
            EXPECT_LT(*reduction.needed, reduction.now);
            EXPECT_NEAR(U, target, tolerance * target) << "component " << reduction.component;
            EXPECT_LE(U, target * (1 + 1e-9)) << "component " << reduction.component;
            const InputSet without = with_figure(inputs, reduction.component, 0.0);
            const double remains = evaluate(model, without, options)->outputs[0].expanded_uncertainty;
            EXPECT_EQ(reduction.rises_again, remains > target) << "component " << reduction.component;
        } else {
            EXPECT_GT(U, target);
        }
    }
    EXPECT_EQ(attainable, expected_attainable);
    EXPECT_EQ(budget.common_factor.has_value(), expected_attainable == 0);
    if (!budget.common_factor) return;
    InputSet all = inputs;
    for (std::size_t c = 0; c < all.components.size(); ++c) all = with_figure(all, c, *budget.common_factor);
    EXPECT_NEAR(evaluate(model, all, options)->outputs[0].expanded_uncertainty, target, tolerance * target);
}

EvaluationOptions first_order() {
    EvaluationOptions options;
    options.method = Method::first_order;
    return options;
}

// U is the target when the component is reduced as was said.
TEST(ReverseBudget, AReducedComponentMeetsTheTarget) {
    expect_targets_met(sum_model(three()), three(), first_order(), 0.8, 1e-9, 2);
    expect_targets_met(sum_model(three()), three(), trials(40'000), 0.8, 2e-4, 2);
}

// The normal part falls, so nu_eff falls and k grows: with k held fixed the target was missed by 20 %.
TEST(ReverseBudget, TheCoverageFactorFollowsTheDegreesOfFreedom) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{10, 3}), infinity);
    add_quantity(inputs, "b", Distribution::of(StudentT{0, 1, 3}), 3);
    for (const double part : {0.9, 0.7, 0.55})
        expect_targets_met(sum_model(inputs), inputs, first_order(), part, 1e-9, 1);
    expect_targets_met(sum_model(inputs), inputs, trials(50'000), 0.7, 2e-4, 1);
}

// u alone would fall, but two degrees of freedom are left of 21: U is 8.6 without the normal part, 7.5 with
// it.
TEST(ReverseBudget, SaysThatUIncreasesWhereTooFewDegreesOfFreedomAreLeft) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{10, 3}), infinity);
    add_quantity(inputs, "b", Distribution::of(StudentT{0, 2, 2}), 2);
    expect_targets_met(sum_model(inputs), inputs, first_order(), 0.95, 1e-9, 2);
    const auto result = evaluate(sum_model(inputs), inputs, first_order()).value();
    const double target = 0.95 * result.outputs[0].expanded_uncertainty;
    const auto budget = reverse_budget(nullptr, result, 0, target).value();
    for (const auto& reduction : budget.reductions)
        EXPECT_EQ(reduction.rises_again, reduction.component == 0) << reduction.component;
}

// Neither variances nor intervals of a product, or of rectangles, add up.
TEST(ReverseBudget, MonteCarloIsNotASumOfVariances) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Rectangular{-1, 3}), infinity);
    add_quantity(inputs, "b", Distribution::of(Rectangular{0.2, 2}), infinity);
    add_quantity(inputs, "c", Distribution::of(Normal{0, 0.3}), infinity);
    const FunctionModel model(inputs, outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0] * x[1] + x[2];
                                  return true;
                              });
    expect_targets_met(model, inputs, trials(60'000), 0.87, 2e-4, 2);
    EvaluationOptions fixed = trials(60'000);
    fixed.coverage_factor = 2.0;
    expect_targets_met(model, inputs, fixed, 0.87, 2e-4, 2);
}

TEST(ReverseBudget, ACommonFactorWhereNoComponentSuffices) {
    InputSet inputs;
    for (const char* name : {"a", "b", "c", "d"})
        add_quantity(inputs, name, Distribution::of(Normal{1, 2}), infinity);
    expect_targets_met(sum_model(inputs), inputs, first_order(), 0.5, 1e-9, 0);
    expect_targets_met(sum_model(inputs), inputs, trials(40'000), 0.5, 2e-4, 0);
}

TEST(ReverseBudget, AMetTargetAsksForNothing) {
    const auto model = sum_model(three());
    const auto result = evaluate_first_order(model, three(), trials(10)).value();
    EXPECT_TRUE(judge(result, {.output = 0, .target_uncertainty = 100.0}).meets_target);
    const auto budget = reverse_budget(&model, result, 0, 100.0).value();
    EXPECT_TRUE(budget.reductions.empty());
    EXPECT_FALSE(budget.common_factor);
}

// JCGM 106 7.4: p_c from the distribution of the result line.
TEST(Requirements, ProbabilityOfConformance) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{10, 1}), infinity);
    const auto model = sum_model(inputs);
    const auto result = evaluate(model, inputs, trials(200'000)).value();
    const auto verdicts =
        judge(result, std::vector<OutputRequirement>{
                          {.output = 0, .lower_limit = 8.0, .upper_limit = 11.0, .guard_factor = 1.0},
                          {.output = 0, .upper_limit = 11.0, .guard_factor = 0.0}});
    const double u = result.outputs[0].standard_uncertainty;
    const auto phi = normal_distribution_function;
    const RequirementResult& both = verdicts.at(0);
    const double p = phi(1) - phi(-2);
    EXPECT_EQ(both.conformance_by, RequirementResult::Distribution::trials);
    EXPECT_NEAR(both.conformance, p, 4 * std::sqrt(p * (1 - p) / 200'000));
    EXPECT_NEAR(*both.capability_index, 3 / (4 * u), 1e-12);
    EXPECT_NEAR(both.guard_band, result.outputs[0].expanded_uncertainty, 1e-12);
    EXPECT_EQ(both.decision, RequirementResult::Decision::reject);  // 10 > 11 - 1.96
    EXPECT_EQ(verdicts.at(1).decision, RequirementResult::Decision::accept);
    EXPECT_FALSE(verdicts.at(1).capability_index.has_value());
    const auto first = evaluate_first_order(model, inputs, trials(10)).value();
    const auto normal = judge(first, {.output = 0, .lower_limit = 8.0, .upper_limit = 11.0});
    EXPECT_EQ(normal.conformance_by, RequirementResult::Distribution::normal);
    EXPECT_NEAR(normal.conformance, p, 1e-12);
}

// Four observations: t with three degrees of freedom, not a normal distribution.
TEST(Requirements, ProbabilityOfConformanceOfFewObservations) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(StudentT{10, 1, 3}), 3);
    const OutputRequirement limit{.output = 0, .upper_limit = 13.182446305284264};
    const auto first = evaluate_first_order(sum_model(inputs), inputs, trials(10)).value();
    EXPECT_EQ(judge(first, limit).conformance_by, RequirementResult::Distribution::student_t);
    EXPECT_NEAR(judge(first, limit).conformance, 0.975, 1e-12);
    const auto both = evaluate(sum_model(inputs), inputs, trials(200'000)).value();
    EXPECT_NEAR(judge(both, limit).conformance, 0.975, 4 * std::sqrt(0.975 * 0.025 / 200'000));
}

/// Share of the values in [low, high], counted.
double counted(const Eigen::MatrixXd& outputs, double low, double high) {
    return (outputs.row(0).array() >= low && outputs.row(0).array() <= high).cast<double>().mean();
}

// The kept distribution says the same as the trials: body, tails, ends, jumps.
TEST(Requirements, TheKeptDistributionIsThatOfTheTrials) {
    constexpr std::uint64_t n = 100'000;
    InputSet continuous, discrete, mixed;
    add_quantity(continuous, "a", Distribution::of(Normal{0, 1}), infinity);
    add_quantity(continuous, "b", Distribution::of(Rectangular{-2, 2}), infinity);
    add_quantity(discrete, "a", Distribution::of(Discrete{{1, 2, 3, 7}, {0.1, 0.4, 0.3, 0.2}}), infinity);
    add_quantity(mixed, "a", Distribution::of(Normal{0, 1}), infinity);
    const auto positive = [](std::span<const double> x, std::span<double> y) {
        y[0] = std::max(0.0, x[0]);
        return true;
    };
    const FunctionModel clipped(mixed, outputs_named({"y"}), positive);
    const auto check = [&](const MeasurementModel& model, const InputSet& inputs,
                           const std::vector<double>& limits, double tolerance) {
        const auto result = evaluate(model, inputs, trials(n)).value();
        const Eigen::MatrixXd outputs = replay_trials(model, inputs, EvaluationOptions{}.seed, 0, n)->outputs;
        const TrialDistribution& kept = result.outputs[0].monte_carlo->distribution;
        for (const double low : limits)
            for (const double high : limits)
                EXPECT_NEAR(kept.inside(low, high), counted(outputs, low, high), tolerance)
                    << low << " " << high;
    };
    // 4 standard deviations of a count inside a cell (0.02 u, some 800 trials), at two limits.
    constexpr double scatter = 8e-4;
    check(sum_model(continuous), continuous,
          {-infinity, -5.0, -3.0, -2.2, -1.0, -0.013, 0.0, 0.7, 1.9, 2.6, 3.1, 4.0, infinity}, scatter);
    check(sum_model(discrete), discrete, {-infinity, 0.5, 1, 1.5, 2, 2.5, 3, 4, 7, 8, infinity}, 2.0 / n);
    check(clipped, mixed, {-infinity, -1e-9, 0.0, 1e-3, 0.5, 1.0, 2.0, 3.0, infinity}, scatter);
}

// An angle at 179.9 degrees is inside -181 ... -179; the limits may be typed on any branch.
TEST(Requirements, AnAngleIsJudgedOnItsCircle) {
    const double deg = std::acos(-1.0) / 180;
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{179.9 * deg, 0.2 * deg}), infinity);
    std::vector<OutputQuantity> outputs = outputs_named({"phi"});
    outputs[0].periodic = true;
    const FunctionModel model(inputs, outputs, [](std::span<const double> x, std::span<double> y) {
        y[0] = std::remainder(x[0], 2 * std::acos(-1.0));
        return true;
    });
    for (const auto& result : {evaluate(model, inputs, trials(50'000)).value(),
                               evaluate_first_order(model, inputs, trials(10)).value()})
        for (const double turn : {-360.0, 0.0, 360.0}) {
            const auto inside = judge(
                result, {.output = 0, .lower_limit = (179 + turn) * deg, .upper_limit = (181 + turn) * deg});
            EXPECT_EQ(inside.decision, RequirementResult::Decision::accept) << turn;
            EXPECT_GT(inside.conformance, 0.9999) << turn;
            const auto outside = judge(
                result, {.output = 0, .lower_limit = (-1 + turn) * deg, .upper_limit = (1 + turn) * deg});
            EXPECT_EQ(outside.decision, RequirementResult::Decision::reject) << turn;
            EXPECT_LT(outside.conformance, 1e-6) << turn;
        }
}

RequirementResult judged_by(GuardRule rule, double U, double target = 0.02) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{0.1, U / 2.0}), infinity);
    EvaluationOptions options = trials(10);
    options.coverage_factor = 2.0;
    const auto result = evaluate_first_order(sum_model(inputs), inputs, options).value();
    return judge(result, {.output = 0,
                          .lower_limit = -1.0,
                          .upper_limit = 1.0,
                          .prior_mean = 0.0,
                          .prior_standard_deviation = 0.5,
                          .guard_rule = rule,
                          .target_risk = target});
}

// Acceptance limits in parts of the tolerance, by hand from the formulas.
TEST(Requirements, GuardBandsByTheirNames) {
    EXPECT_NEAR(judged_by(GuardRule::rss, 0.5).guard_band, 1 - std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(judged_by(GuardRule::rss, 1e-9).guard_band, 0.5e-18, 1e-24);
    EXPECT_NEAR(judged_by(GuardRule::rp10, 0.5).guard_band, 1 - (1.25 - 0.5), 1e-12);
    EXPECT_EQ(judged_by(GuardRule::rp10, 0.25).guard_band, 0.0);
    EXPECT_EQ(judged_by(GuardRule::rp10, 0.1).guard_band, 0.0);
    EXPECT_NEAR(judged_by(GuardRule::dobbert, 0.5).guard_band,
                0.5 * (1.04 - std::exp(0.38 * std::log(2.0) - 0.54)), 1e-12);
    EXPECT_EQ(judged_by(GuardRule::dobbert, 0.2).guard_band, 0.0) << "TUR 5";
    EXPECT_GT(judged_by(GuardRule::dobbert, 0.22).guard_band, 0.0) << "TUR 4.5";
    EXPECT_EQ(judged_by(GuardRule::rss, 2.0).decision, RequirementResult::Decision::reject);
    EXPECT_EQ(judged_by(GuardRule::rp10, 2.0).decision, RequirementResult::Decision::reject);
}

// Dobbert's promise: at most 2 % of all items are falsely accepted, whatever the process.
TEST(Requirements, TheManagedGuardBandKeepsFalseAcceptsBelowTwoPercent) {
    for (const double ratio : {1.2, 1.5, 2.0, 3.0, 4.0, 4.5, 6.0, 10.0})
        for (double sd = 0.2; sd < 3.0; sd += 0.05) {
            const double U = 1.0 / ratio, w = judged_by(GuardRule::dobbert, U).guard_band;
            EXPECT_LT(global_risks({-1, 1, w - 1, 1 - w}, 0.0, sd, U / 2).consumer, 0.0205)
                << ratio << ", " << sd;
        }
}

TEST(Requirements, AGuardBandMeetsItsTargetRisk) {
    for (const double U : {0.05, 0.3, 0.8})
        for (const double target : {1e-4, 0.005, 0.02}) {
            const double u = U / 2;
            const double specific = judged_by(GuardRule::specific_risk, U, target).guard_band;
            if (std::isfinite(specific)) {
                const double out = normal_distribution_function(-specific / u) +
                                   normal_distribution_function((specific - 2) / u);
                EXPECT_NEAR(out, target, 1e-8) << U << ", " << target;
            } else {
                EXPECT_GT(2 * normal_distribution_function(-1 / u), target) << U << ", " << target;
            }
            const double global = judged_by(GuardRule::global_risk, U, target).guard_band;
            const auto risks = global_risks({-1, 1, global - 1, 1 - global}, 0.0, 0.5, u);
            EXPECT_LE(risks.consumer, target * (1 + 1e-6));
            if (global > 0) {
                EXPECT_NEAR(risks.consumer, target, 1e-6) << U << ", " << target;
            }
            const double accepted = judged_by(GuardRule::accepted_risk, U, target).guard_band;
            if (!std::isfinite(accepted)) continue;
            const auto of_accepted = global_risks({-1, 1, accepted - 1, 1 - accepted}, 0.0, 0.5, u);
            EXPECT_LE(of_accepted.consumer_if_accepted, target * (1 + 1e-6));
            EXPECT_GE(accepted, global) << "less is accepted than is there";
        }
    EXPECT_EQ(judged_by(GuardRule::global_risk, 0.1, 0.4).guard_band, 0.0) << "none is needed";
}

// Against a sum over a fine grid of the two-dimensional integral of JCGM 106 9.5.
TEST(Requirements, GlobalRisks) {
    const ToleranceLimits limits{-1.0, 1.2, -0.9, 1.0};
    const double mean = 0.2, sd = 0.6, u = 0.15;
    const auto risks = global_risks(limits, mean, sd, u);
    double consumer = 0, producer = 0;
    constexpr double h = 0.002;
    for (double eta = -4; eta < 4.4; eta += h)
        for (double measured = eta - 8 * u + h / 2; measured < eta + 8 * u; measured += 2 * h) {
            const double weight =
                normal_density((eta - mean) / sd) / sd * normal_density((measured - eta) / u) / u * 2 * h * h;
            const bool conforms = eta >= limits.lower && eta <= limits.upper;
            const bool accepted = measured >= limits.accept_lower && measured <= limits.accept_upper;
            if (accepted && !conforms) consumer += weight;
            if (!accepted && conforms) producer += weight;
        }
    EXPECT_NEAR(risks.consumer, consumer, 2e-4);
    EXPECT_NEAR(risks.producer, producer, 5e-4);
    double accepted = 0, rejected = 0;
    for (double eta = -4; eta < 4.4; eta += h) {
        const double weight = normal_density((eta - mean) / sd) / sd * h;
        const double p = normal_distribution_function((limits.accept_upper - eta) / u) -
                         normal_distribution_function((limits.accept_lower - eta) / u);
        accepted += weight * p;
        rejected += weight * (1 - p);
    }
    EXPECT_NEAR(risks.consumer_if_accepted, risks.consumer / accepted, 1e-6);
    EXPECT_NEAR(risks.producer_if_rejected, risks.producer / rejected, 1e-6);
    EXPECT_GT(risks.consumer, 0.001);
    EXPECT_GT(risks.producer, 0.01);
    // A perfect measuring system with simple acceptance makes no wrong decision.
    const auto perfect = global_risks({-1, 1, -1, 1}, mean, sd, 0.0);
    EXPECT_NEAR(perfect.consumer, 0.0, 1e-12);
    EXPECT_NEAR(perfect.producer, 0.0, 1e-12);
}

}  // namespace
}  // namespace covaria::test::requirements_test
