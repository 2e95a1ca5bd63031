// Draws of correlated components of any distribution have the correlation that was stated.
#include <gtest/gtest.h>

#include <cmath>

#include "core/propagation/draw_plan.h"
#include "core/propagation/engine.h"
#include "core/quantity/copula.h"
#include "test_models.h"

namespace covaria::test::correlation_test {
namespace {

std::vector<Distribution> every_distribution() {
    return {Distribution::of(Normal{1.0, 2.0}),
            Distribution::of(StudentT{1.0, 0.5, 9.0}),
            Distribution::of(Rectangular{-1.0, 3.0}),
            Distribution::of(CurvilinearTrapezoid{-1.0, 1.0, 0.3}),
            Distribution::of(Trapezoidal{0.0, 1.0, 0.4}),
            Distribution::of(Triangular{-1.0, 1.0}),
            Distribution::of(Arcsine{-2.0, 2.0}),
            Distribution::of(Exponential{0.7}),
            Distribution::of(Exponential{0.7}).scaled(-2.0).shifted(1.0),
            Distribution::of(Gamma{2.5, 1.0}),
            Distribution::of(TruncatedNormal{0.0, 1.0, -0.5, 2.0}),
            Distribution::of(Lognormal{0.0, 0.4}),
            Distribution::of(Beta{0.0, 1.0, 2.0, 5.0}),
            Distribution::of(Discrete{{0.0, 1.0, 3.0}, {0.2, 0.5, 0.3}})};
}

struct Estimated {
    double value = 0.0, standard_error = 0.0;
};

/// Variance of a - b u_a/u_b, over that by the law of propagation.
Estimated variance_ratio(const InputSet& inputs, double r, std::uint64_t seed) {
    const detail::DrawPlan plan(inputs, inputs.correlations);
    detail::TrialRows rows(2);
    detail::DrawWorkspace workspace(plan.latent_rows());
    double scale[2], mean[2];
    for (std::size_t i = 0; i < 2; ++i) {
        scale[i] = 1.0 / inputs.components[i].distribution.standard_deviation();
        mean[i] = inputs.components[i].distribution.mean();
    }
    double n = 0.0, sum = 0.0, squares = 0.0;
    for (std::uint64_t first = 0; first < 100'000; first += 1000) {
        plan.draw(seed, first, 1000, rows, workspace);
        for (std::size_t t = 0; t < 1000; ++t) {
            const double difference =
                scale[0] * (rows.row(0)[t] - mean[0]) - scale[1] * (rows.row(1)[t] - mean[1]);
            const double square = difference * difference / (2.0 * (1.0 - r));
            n += 1.0, sum += square, squares += square * square;
        }
    }
    const double average = sum / n;
    return {average, std::sqrt((squares / n - average * average) / n)};
}

TEST(StatedCorrelation, EveryPairOfDistributions) {
    const std::vector<Distribution> all = every_distribution();
    int accepted = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i; j < all.size(); ++j)
            for (const double r : {-0.8, 0.5, 0.9}) {
                InputSet inputs;
                add_quantity(inputs, "a", all[i]);
                add_quantity(inputs, "b", all[j]);
                inputs.correlations = {{0, 1, r}};
                const auto copula = detail::copula_coefficients(inputs, inputs.correlations);
                // The end of the possible range stands for coefficients just beyond it.
                if (!copula || std::abs(copula->front().coefficient) == 1.0) continue;
                ++accepted;
                const Estimated ratio = variance_ratio(inputs, r, 10 * i + j);
                // Over 260 cases the largest of as many standard errors is near 3.
                EXPECT_NEAR(ratio.value, 1.0, 4.5 * ratio.standard_error)
                    << all[i].title() << ", " << all[j].title() << ", r = " << r;
            }
    EXPECT_GT(accepted, 250);
}

// u(a - b) for r = .9 is the GUM's, whatever the distribution.
TEST(StatedCorrelation, UncertaintyOfADifference) {
    for (const Distribution& d :
         {Distribution::of(Rectangular{-1.0, 1.0}), Distribution::of(Arcsine{-1.0, 1.0}),
          Distribution::of(Exponential{1.0}), Distribution::of(StudentT{0.0, 1.0, 4.0})}) {
        InputSet inputs;
        add_quantity(inputs, "a", d);
        add_quantity(inputs, "b", d.scaled(-1.0));
        inputs.correlations = {{0, 1, -0.9}};
        EvaluationOptions options;
        options.trials = 1'000'000;
        const auto result = evaluate(sum_model(inputs), inputs, options);
        ASSERT_TRUE(result) << result.error().message.english();
        const double u = d.standard_deviation() * std::sqrt(2.0 * (1.0 - 0.9));
        // A t distribution with four degrees of freedom has no fourth moment: seeds scatter by 1 %.
        EXPECT_NEAR(result->outputs[0].standard_uncertainty, u, (d.kind() == "student-t" ? 0.03 : 0.008) * u)
            << d.title();
    }
}

// A member of an estimate of variance and a component outside: one chi^2 of the member's own.
TEST(StatedCorrelation, MemberOfAnEstimateWithAnotherComponent) {
    for (const Distribution& other : {Distribution::normal(2.0), Distribution::of(Rectangular{-1.0, 1.0}),
                                      Distribution::of(StudentT{0.0, 1.0, 10.0})}) {
        InputSet inputs;
        add_quantity(inputs, "member", Distribution::of(StudentT{0.0, 1.0, 12.0}));
        inputs.rest_on_estimate("s", 0);
        add_quantity(inputs, "other", other);
        inputs.correlations = {{0, 1, 0.8}};
        ASSERT_TRUE(resolved_correlations(inputs)) << resolved_correlations(inputs).error().message.english();
        const Estimated ratio = variance_ratio(inputs, 0.8, 3);
        EXPECT_NEAR(ratio.value, 1.0, 4.0 * ratio.standard_error) << other.title();
    }
}

TEST(StatedCorrelation, WhatCannotHoldTogetherIsSaid) {
    InputSet inputs;
    for (const char* name : {"a", "b", "c"})
        add_quantity(inputs, name, Distribution::of(Rectangular{-1.0, 1.0}));
    inputs.correlations = {{0, 2, 0.7071}, {1, 2, 0.7071}};
    EvaluationOptions options;
    options.trials = 100'000;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->warnings.size(), 1u);
    EXPECT_NE(result->warnings[0].english().find("cannot all hold with these distributions"),
              std::string::npos);
}

}  // namespace
}  // namespace covaria::test::correlation_test
