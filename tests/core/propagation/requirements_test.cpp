// Target uncertainties and their reductions, conformity and risks.
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/propagation/engine.h"
#include "core/propagation/requirements.h"
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

// With the component reduced to what was said, U is the target.
TEST(Requirements, AReducedComponentMeetsTheTarget) {
    const InputSet inputs = three();
    const auto model = sum_model(inputs);
    const auto result = evaluate_first_order(model, inputs, trials(10)).value();
    const double target = 0.8 * result.outputs[0].expanded_uncertainty;
    const auto checked = check_requirements(model, result, {{.output = 0, .target_uncertainty = target}});
    ASSERT_TRUE(checked);
    ASSERT_EQ(checked->size(), 1u);
    EXPECT_FALSE(checked->front().meets_target);
    std::size_t attainable = 0;
    for (const auto& reduction : checked->front().reductions) {
        InputSet reduced = inputs;
        auto& distribution = reduced.components[reduction.component].distribution;
        distribution = Distribution::of(Normal{distribution.mean(), reduction.needed.value_or(0.0)});
        const double U = evaluate_first_order(model, reduced, trials(10))->outputs[0].expanded_uncertainty;
        if (reduction.needed) {
            ++attainable;
            EXPECT_LT(*reduction.needed, reduction.now);
            EXPECT_NEAR(U, target, 1e-9 * target);
        } else {
            EXPECT_GT(U, target);
        }
    }
    EXPECT_EQ(checked->front().reductions.size(), 3u);
    EXPECT_EQ(attainable, 2u);
}

TEST(Requirements, AMetTargetAsksForNothing) {
    const InputSet inputs = three();
    const auto result = evaluate_first_order(sum_model(inputs), inputs, trials(10)).value();
    const auto checked =
        check_requirements(sum_model(inputs), result, {{.output = 0, .target_uncertainty = 100.0}});
    EXPECT_TRUE(checked->front().meets_target);
    EXPECT_TRUE(checked->front().reductions.empty());
}

// JCGM 106 7.4: p_c from the normal distribution; counted in trials it is the same.
TEST(Requirements, ProbabilityOfConformance) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::of(Normal{10, 1}), infinity);
    const auto model = sum_model(inputs);
    const auto result = evaluate(model, inputs, trials(200'000)).value();
    const auto checked =
        check_requirements(model, result,
                           {{.output = 0, .lower_limit = 8.0, .upper_limit = 11.0, .guard_factor = 1.0},
                            {.output = 0, .upper_limit = 11.0, .guard_factor = 0.0}});
    ASSERT_TRUE(checked);
    const double y = result.outputs[0].estimate, u = result.outputs[0].standard_uncertainty;
    const auto phi = normal_distribution_function;
    const RequirementResult& both = checked->at(0);
    EXPECT_NEAR(both.conformance_normal, phi((11 - y) / u) - phi((8 - y) / u), 1e-12);
    const double p = phi(1) - phi(-2);
    EXPECT_NEAR(*both.conformance_monte_carlo, p, 4 * std::sqrt(p * (1 - p) / 200'000));
    EXPECT_NEAR(*both.capability_index, 3 / (4 * u), 1e-12);
    EXPECT_NEAR(both.guard_band, result.outputs[0].expanded_uncertainty, 1e-12);
    EXPECT_EQ(both.decision, RequirementResult::Decision::reject);  // 10 > 11 - 1.96
    EXPECT_EQ(checked->at(1).decision, RequirementResult::Decision::accept);
    EXPECT_FALSE(checked->at(1).capability_index.has_value());
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
    EXPECT_GT(risks.consumer, 0.001);
    EXPECT_GT(risks.producer, 0.01);
    // A perfect measuring system with simple acceptance makes no wrong decision.
    const auto perfect = global_risks({-1, 1, -1, 1}, mean, sd, 0.0);
    EXPECT_NEAR(perfect.consumer, 0.0, 1e-12);
    EXPECT_NEAR(perfect.producer, 0.0, 1e-12);
}

}  // namespace
}  // namespace covaria::test::requirements_test
