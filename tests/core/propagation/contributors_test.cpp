// Results with everything of a contributor held, vectors of random direction in a whole evaluation.
#include <gtest/gtest.h>

#include <cmath>

#include "core/propagation/engine.h"
#include "core/quantity/isotropic_vector.h"
#include "tests/core/propagation/test_models.h"

namespace covaria::contributors_test {
namespace {

/// One own component of standard uncertainty u for each quantity, by contributors.
InputSet inputs_by(const std::vector<std::pair<std::string, double>>& contributors) {
    InputSet inputs;
    for (const auto& [contributor, u] : contributors) {
        const std::string symbol = "x_" + std::to_string(inputs.quantities.size() + 1);
        inputs.add({.symbol = symbol, .name = symbol}, {{.id = symbol,
                                                         .name = symbol,
                                                         .distribution = Distribution::normal(u),
                                                         .contributor = contributor}});
    }
    return inputs;
}

test::FunctionModel sum_of(const InputSet& inputs) {
    const std::size_t n = inputs.quantities.size();
    return {inputs, {{.symbol = "y", .name = "y"}}, [n](std::span<const double> x, std::span<double> y) {
                y[0] = 0.0;
                for (std::size_t i = 0; i < n; ++i) y[0] += x[i];
                return true;
            }};
}

TEST(Contributors, WithoutAndAloneByBothMethods) {
    InputSet inputs = inputs_by({{"robot", 3.0}, {"bars", 4.0}, {"robot", 12.0}, {"", 5.0}});
    inputs.correlations.push_back({0, 2, 0.5});
    const test::FunctionModel model = sum_of(inputs);
    EvaluationOptions options;
    options.trials = options.contributor_trials = 100'000;
    const UncertaintyResult r = evaluate(model, inputs, options).value();
    ASSERT_EQ(r.contributors.size(), 3u);
    const double robot = std::sqrt(9.0 + 144.0 + 36.0), others = std::sqrt(16.0 + 25.0);
    const ContributorResult& first = r.contributors[0];
    EXPECT_EQ(first.contributor, "robot");
    EXPECT_EQ(first.components, 2u);
    EXPECT_NEAR(first.without.first_order[0], others, 1e-9);
    EXPECT_NEAR(first.alone.first_order[0], robot, 1e-9);
    const double error = 4.0 / std::sqrt(2e5);
    EXPECT_NEAR(first.without.monte_carlo[0], others, others * error);
    EXPECT_NEAR(first.alone.monte_carlo[0], robot, robot * error);
    EXPECT_NEAR(r.contributors[2].alone.monte_carlo[0], 5.0, 5.0 * error);
}

TEST(Contributors, OfTwoOneAloneIsWhatRemainsWithoutTheOther) {
    const InputSet inputs = inputs_by({{"robot", 3.0}, {"bars", 4.0}});
    const test::FunctionModel model = sum_of(inputs);
    EvaluationOptions options;
    options.trials = options.contributor_trials = 10'000;
    const UncertaintyResult r = evaluate(model, inputs, options).value();
    ASSERT_EQ(r.contributors.size(), 2u);
    EXPECT_EQ(r.contributors[0].alone.monte_carlo, r.contributors[1].without.monte_carlo);
    EXPECT_EQ(r.contributors[1].alone.monte_carlo, r.contributors[0].without.monte_carlo);
}

TEST(Contributors, OneIsNoneAndHeldOnesDoNotCount) {
    InputSet inputs = inputs_by({{"robot", 3.0}, {"bars", 4.0}});
    inputs.components[1].held = true;
    const test::FunctionModel model = sum_of(inputs);
    EXPECT_TRUE(evaluate_first_order(model, inputs, {}).value().contributors.empty());
}

/// The distance of a vector of random direction from the origin, and its first coordinate.
TEST(VectorsOfRandomDirection, AreDrawnTogetherInARun) {
    InputSet inputs;
    for (const std::string axis : {"x", "y", "z"})
        inputs.add(
            {.symbol = axis, .name = axis, .offset = axis == "x" ? 1e-3 : 0.0},
            {{.id = axis, .name = axis, .distribution = coordinate_distribution({RadialLaw::sphere, 2.0})}});
    inputs.vectors.push_back({{0, 1, 2}});
    const test::FunctionModel model(inputs, {{.symbol = "r", .name = "r"}, {.symbol = "x", .name = "x"}},
                                    [](std::span<const double> x, std::span<double> y) {
                                        y[0] = std::hypot(x[0] - 1e-3, x[1], x[2] + 1e-9);
                                        y[1] = x[0];
                                        return true;
                                    });
    EvaluationOptions options;
    options.trials = 20'000;
    const UncertaintyResult r = evaluate(model, inputs, options).value();
    EXPECT_NEAR(r.outputs[0].estimate, 2.0, 1e-8);
    EXPECT_LT(r.outputs[0].standard_uncertainty, 1e-8);
    EXPECT_NEAR(r.outputs[1].standard_uncertainty, 2.0 / std::sqrt(3.0), 0.02);
    // Edited to different distributions they are independent: the length varies, and the result says so.
    inputs.components[0].distribution = Distribution::normal(1.0);
    const UncertaintyResult torn = evaluate(model, inputs, options).value();
    EXPECT_GT(torn.outputs[0].standard_uncertainty, 0.1);
    ASSERT_FALSE(torn.warnings.empty());
    EXPECT_NE(torn.warnings[0].english().find("drawn independently"), std::string::npos);
}

}  // namespace
}  // namespace covaria::contributors_test
