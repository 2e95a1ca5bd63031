// The result line: which U it states, for which method, and that U, interval and k belong together.
#include "core/result/result_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/special_quantiles.h"
#include "core/propagation/engine.h"
#include "core/propagation/evaluate_summary.h"
#include "test_models.h"

namespace covaria::test::result_line_test {
namespace {

EvaluationOptions options_with(Method method, std::optional<double> k = {}) {
    EvaluationOptions options;
    options.method = method;
    options.trials = 400'000;
    options.maximum_trials = 400'000;
    options.coverage_factor = k;
    return options;
}

/// The mean of n observations with scatter s.
InputSet mean_of(int n, double s) {
    InputSet inputs;
    const double nu = n - 1;
    add_quantity(inputs, "x", Distribution::of(StudentT{10, s / std::sqrt(n), nu}), nu);
    return inputs;
}

// Half of the interval is t_p(nu) s/sqrt(n), by either method; not that times the u of the t distribution.
TEST(ResultLine, TheDegreesOfFreedomCountOnce) {
    for (const int n : {3, 4, 5, 10}) {
        const InputSet inputs = mean_of(n, 0.2);
        const auto model = sum_model(inputs);
        const double right = t_quantile(0.975, n - 1) * 0.2 / std::sqrt(n);
        const auto first = evaluate(model, inputs, options_with(Method::first_order)).value();
        EXPECT_NEAR(first.outputs[0].expanded_uncertainty, right, 1e-12);
        EXPECT_EQ(expanded_by(first), ExpandedBy::degrees_of_freedom);
        const auto trials = evaluate(model, inputs, options_with(Method::monte_carlo)).value();
        // Standard error of a quantile: sqrt(q(1 - q)/M)/density; the half width has 1/sqrt(2) of it.
        const double error = 0.2 / std::sqrt(n) * std::sqrt(0.025 * 0.975 / 400'000 / 2) /
                             Distribution::of(StudentT{0, 1, n - 1.0}).density(t_quantile(0.975, n - 1));
        const OutputResult& y = trials.outputs[0];
        EXPECT_NEAR(y.expanded_uncertainty, right, 4 * error) << n;
        EXPECT_EQ(expanded_by(trials), ExpandedBy::interval);
        if (n > 3) {
            EXPECT_NEAR(y.coverage_factor, y.expanded_uncertainty / y.standard_uncertainty, 1e-12);
            continue;
        }
        EXPECT_TRUE(std::isinf(y.standard_uncertainty)) << "t with two degrees of freedom has no variance";
        EXPECT_TRUE(std::isnan(y.coverage_factor));
        EXPECT_TRUE(std::isnan(existing_covariance(trials)(0, 0))) << "that of the trials wanders";
        EXPECT_TRUE(std::isnan(y.monte_carlo->standard_error_of_mean));
        EXPECT_TRUE(std::isnan(y.monte_carlo->standard_error_of_uncertainty));
    }
}

// Two observations: not even an expectation.
TEST(ResultLine, WithoutAnExpectationTheEstimateIsThatOfTheInputs) {
    const InputSet inputs = mean_of(2, 0.2);
    const auto result = evaluate(sum_model(inputs), inputs, options_with(Method::monte_carlo)).value();
    EXPECT_EQ(result.outputs[0].estimate, 10.0);
    EXPECT_NEAR(result.outputs[0].expanded_uncertainty, t_quantile(0.975, 1) * 0.2 / std::sqrt(2.0), 0.05);
}

TEST(ResultLine, AFixedCoverageFactorIsThatOfBothMethods) {
    const InputSet inputs = mean_of(10, 0.2);
    for (const Method method : {Method::first_order, Method::monte_carlo}) {
        const auto result = evaluate(sum_model(inputs), inputs, options_with(method, 3.0)).value();
        const OutputResult& y = result.outputs[0];
        EXPECT_EQ(y.coverage_factor, 3.0);
        EXPECT_EQ(y.expanded_uncertainty, 3.0 * y.standard_uncertainty);
        EXPECT_EQ(expanded_by(result), ExpandedBy::fixed_factor);
        // The interval keeps its probability.
        const CoverageInterval interval = coverage_interval_of(y, result);
        EXPECT_NEAR(0.5 * (interval.high - interval.low), t_quantile(0.975, 9) * 0.2 / std::sqrt(10.0), 1e-3);
    }
}

// A study states at a grid point what a run states, however many trials there are.
TEST(ResultLine, TheSummaryStatesTheSame) {
    InputSet inputs = mean_of(5, 0.2);
    add_quantity(inputs, "r", Distribution::of(Rectangular{-0.1, 0.1}), infinity);
    add_quantity(inputs, "e", Distribution::of(Exponential{0.1}), infinity);
    const auto model = sum_model(inputs);
    for (const std::uint64_t trials : {2ULL, 100ULL, 9'999ULL, 10'000ULL, 10'001ULL, 123'456ULL})
        for (const std::optional<double> k : {std::optional<double>(), std::optional<double>(2.0)}) {
            EvaluationOptions options = options_with(Method::monte_carlo, k);
            options.trials = trials;
            const auto whole = evaluate(model, inputs, options).value();
            const auto summary =
                evaluate_summary(model, inputs, {0}, options, [](std::uint64_t) { return true; }).value();
            EXPECT_NEAR(summary.expanded_uncertainty(0), whole.outputs[0].expanded_uncertainty, 1e-12);
            EXPECT_NEAR(summary.standard_uncertainty(0), whole.outputs[0].standard_uncertainty, 1e-12);
        }
}

}  // namespace
}  // namespace covaria::test::result_line_test
