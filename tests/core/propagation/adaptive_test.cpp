// The adaptive procedure with Student t inputs, over many seeds against exact quantiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/special_quantiles.h"
#include "core/propagation/adaptive.h"
#include "core/propagation/engine.h"
#include "test_models.h"

namespace covaria::test::adaptive_test {
namespace {

EvaluationOptions adaptive(std::uint64_t seed, int digits) {
    EvaluationOptions options;
    options.method = Method::adaptive;
    options.significant_digits = digits;
    options.maximum_trials = 5'000'000;
    options.seed = seed;
    return options;
}

std::string all_warnings(const UncertaintyResult& result) {
    std::string text;
    for (const Message& warning : result.warnings) text += warning.english();
    return text;
}

/// Largest deviation of what is judged from the exact value, in tolerances.
double largest_error(const MonteCarloOutput& y, double nu, double delta) {
    double error = std::abs(y.symmetric.high - 10.0 - t_quantile(0.975, nu));
    error = std::max(error, std::abs(y.symmetric.low - 10.0 + t_quantile(0.975, nu)));
    if (nu > 2.0) error = std::max(error, std::abs(y.mean - 10.0));
    if (nu > 4.0) error = std::max(error, std::abs(y.standard_uncertainty - std::sqrt(nu / (nu - 2.0))));
    return error / delta;
}

// u, or for want of u the half-width over 1.96, is 6.5, 2.2, 1.6, 1.4, 1.3, 1.1.
TEST(AdaptiveWithStudentT, StabilisedMeansWithinTheTolerance) {
    constexpr int seeds = 30;
    for (const double nu : {1.0, 2.0, 3.0, 4.0, 5.0, 9.0}) {
        InputSet inputs;
        add_quantity(inputs, "x", Distribution::of(StudentT{10.0, 1.0, nu}));
        const int digits = nu == 1.0 ? 1 : 2;
        int beyond = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const auto result = evaluate(sum_model(inputs), inputs, adaptive(seed, digits));
            ASSERT_TRUE(result) << result.error().message.english();
            ASSERT_TRUE(result->stabilised) << nu;
            const double error = largest_error(*result->outputs[0].monte_carlo, nu, digits == 1 ? 0.5 : 0.05);
            beyond += error > 1.0;
            EXPECT_LT(error, 2.5) << nu << ", seed " << seed;
            const std::string warnings = all_warnings(*result);
            EXPECT_EQ(warnings.find("does not exist") != std::string::npos, nu <= 2.0) << warnings;
            EXPECT_EQ(warnings.find("cannot stabilise") != std::string::npos, nu > 2.0 && nu <= 4.0)
                << warnings;
        }
        EXPECT_LE(beyond, 7) << nu;  // two standard deviations of each of up to four statistics
    }
}

TEST(AdaptiveWithStudentT, OthersAreJudgedByEverything) {
    detail::WatchedStatistics watched;
    watched.outputs = {0, 2};
    watched.least_degrees_of_freedom = {3.0, infinity};
    EXPECT_EQ(watched.judged(), (std::vector<bool>{true, false, true, true, true, true, true, true, false}));
    watched.least_degrees_of_freedom = {5.0, infinity};
    EXPECT_EQ(watched.judged(), std::vector<bool>(9, true));
    watched.outputs = {0};
    watched.least_degrees_of_freedom = {2.0};
    EXPECT_EQ(watched.judged(), (std::vector<bool>{false, false, true, true}));
}

}  // namespace
}  // namespace covaria::test::adaptive_test
