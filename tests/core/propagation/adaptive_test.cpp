// The adaptive procedure with Student t inputs, over many seeds against exact quantiles.
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/special_quantiles.h"
#include "core/propagation/adaptive.h"
#include "core/propagation/engine.h"
#include "test_models.h"

namespace covaria::test::adaptive_test {
namespace {

EvaluationOptions adaptive(std::uint64_t seed) {
    EvaluationOptions options;
    options.method = Method::adaptive;
    options.significant_digits = 1;
    options.maximum_trials = 2'000'000;
    options.seed = seed;
    return options;
}

TEST(AdaptiveWithStudentT, StabilisedMeansWithinTheTolerance) {
    constexpr int seeds = 40;
    for (const double nu : {1.0, 2.0, 3.0, 4.0, 5.0, 9.0}) {
        InputSet inputs;
        add_quantity(inputs, "x", Distribution::of(StudentT{10.0, 1.0, nu}));
        const double high = 10.0 + t_quantile(0.975, nu);
        // One digit of u, or for want of u of the half-width over 1.96.
        const double delta = nu <= 4.0 && t_quantile(0.975, nu) / 1.96 < 1.0 ? 0.05 : 0.5;
        int beyond = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const auto result = evaluate(sum_model(inputs), inputs, adaptive(seed));
            ASSERT_TRUE(result) << result.error().message;
            ASSERT_TRUE(result->stabilised) << nu;
            const MonteCarloOutput& y = *result->outputs[0].monte_carlo;
            bool within = std::abs(y.symmetric.high - high) <= delta;
            if (nu > 2.0) within = within && std::abs(y.mean - 10.0) <= delta;
            if (nu > 4.0)
                within = within && std::abs(y.standard_uncertainty - std::sqrt(nu / (nu - 2.0))) <= delta;
            beyond += !within;
            std::string warnings;
            for (const std::string& warning : result->warnings) warnings += warning;
            EXPECT_EQ(warnings.find("does not exist") != std::string::npos, nu <= 2.0) << warnings;
            EXPECT_EQ(warnings.find("cannot stabilise") != std::string::npos, nu > 2.0 && nu <= 4.0)
                << warnings;
        }
        EXPECT_LE(beyond, 4) << nu;  // 5 % of 40, and what chance adds
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
