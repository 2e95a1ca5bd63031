// Sobol indices against exact ones.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/propagation/engine.h"
#include "test_models.h"

namespace covaria::test::sobol_test {
namespace {

EvaluationOptions sobol(std::uint64_t trials) {
    EvaluationOptions options;
    options.trials = 10'000;
    options.sobol_trials = trials;
    return options;
}

const SobolIndex& index_of(const UncertaintyResult& result, const std::string& name) {
    for (const SobolIndex& s : result.sobol.at(0))
        if (s.name == name) return s;
    throw std::runtime_error("no index of " + name);
}

void expect_index(const SobolIndex& s, double first, double total) {
    EXPECT_NEAR(s.first, first, 4 * s.first_standard_error + 1e-12) << s.name;
    EXPECT_NEAR(s.total, total, 4 * s.total_standard_error + 1e-12) << s.name;
    EXPECT_LT(s.first_standard_error, 0.02);
    EXPECT_LT(s.total_standard_error, 0.02);
}

// I. M. Sobol, T. Homma, A. Saltelli: y = sin x1 + a sin^2 x2 + b x3^4 sin x1, x rectangular in [-pi, pi].
TEST(Sobol, IshigamiFunction) {
    constexpr double a = 7, b = 0.1, pi = std::numbers::pi;
    InputSet inputs;
    for (const char* name : {"x1", "x2", "x3"})
        add_quantity(inputs, name, Distribution::of(Rectangular{-pi, pi}), infinity);
    const FunctionModel model(
        inputs, outputs_named({"y"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = std::sin(x[0]) + a * std::pow(std::sin(x[1]), 2) + b * std::pow(x[2], 4) * std::sin(x[0]);
            return true;
        },
        [](std::span<const double>, Eigen::MatrixXd& j) {
            j << 1, 0, 0;
            return true;
        });
    const double v1 = 0.5 * std::pow(1 + b * std::pow(pi, 4) / 5, 2), v2 = a * a / 8;
    const double v13 = b * b * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), v = v1 + v2 + v13;
    const auto result = evaluate(model, inputs, sobol(200'000));
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_EQ(result->sobol_trials, 200'000u);
    ASSERT_EQ(result->sobol.at(0).size(), 3u);
    expect_index(index_of(*result, result->inputs->components[0].id), v1 / v, (v1 + v13) / v);
    expect_index(index_of(*result, result->inputs->components[1].id), v2 / v, v2 / v);
    expect_index(index_of(*result, result->inputs->components[2].id), 0, v13 / v);
}

// y = x1 x2 + x3 with estimates zero: the law of propagation sees x3 alone, which has a fifth of the
// variance.
TEST(Sobol, WhatOnlyInteractsIsInTheBudget) {
    InputSet inputs;
    for (const char* name : {"x1", "x2", "x3"})
        add_quantity(inputs, name, Distribution::of(Normal{0, 2}), infinity);
    const FunctionModel model(inputs, outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0] * x[1] + x[2];
                                  return true;
                              });
    EXPECT_EQ(evaluate(model, inputs, sobol(0))->budget.rows.at(0).size(), 1u);
    const auto result = evaluate(model, inputs, sobol(20'000)).value();
    const std::vector<BudgetRow>& rows = result.budget.rows.at(0);
    ASSERT_EQ(rows.size(), 3u);
    for (const BudgetRow& row : rows) EXPECT_EQ(row.contribution, row.component == 2 ? 2.0 : 0.0);
    for (const char* name : {"x1", "x2"}) expect_index(index_of(result, name), 0.0, 0.8);
    expect_index(index_of(result, "x3"), 0.2, 0.2);
}

// The budget has a zero for every component where the law of propagation sees nothing at all.
TEST(Sobol, WhatNothingInfluencesToFirstOrderHasABudgetOfZeros) {
    InputSet inputs;
    for (const char* name : {"x1", "x2"})
        add_quantity(inputs, name, Distribution::of(Normal{0, 2}), infinity);
    const FunctionModel model(inputs, outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = x[0] * x[1];
                                  return true;
                              });
    const auto result = evaluate(model, inputs, sobol(0));
    ASSERT_EQ(result->budget.rows.at(0).size(), 2u);
    for (const BudgetRow& row : result->budget.rows[0]) EXPECT_EQ(row.sensitivity, 0.0);
}

// Correlated components have an index together; in a sum, first and total agree.
TEST(Sobol, CorrelatedComponentsAreOneFactor) {
    InputSet inputs;
    for (const char* name : {"a", "b", "c"}) add_quantity(inputs, name, Distribution::normal(1), infinity);
    inputs.correlations.push_back({0, 1, 0.5});
    const auto result = evaluate(sum_model(inputs), inputs, sobol(100'000));
    ASSERT_TRUE(result);
    ASSERT_EQ(result->sobol.at(0).size(), 2u);
    const std::string joint = inputs.components[0].id + ", " + inputs.components[1].id;
    expect_index(index_of(*result, joint), 0.75, 0.75);
    expect_index(index_of(*result, inputs.components[2].id), 0.25, 0.25);
}

// Over many seeds the indices scatter as their standard errors say.
TEST(Sobol, StandardErrorsAreTheScatter) {
    InputSet inputs;
    for (const char* name : {"a", "b", "c"})
        add_quantity(inputs, name, Distribution::of(Rectangular{-1, 1}), infinity);
    const FunctionModel model(inputs, outputs_named({"y"}),
                              [](std::span<const double> x, std::span<double> y) {
                                  y[0] = 5.0 + 3.0 * x[0] + x[1] + 2.0 * x[1] * x[2] + x[2] * x[2];
                                  return true;
                              });
    constexpr int seeds = 400;
    const auto names = std::vector<std::string>{"a", "b", "c"};
    for (const std::string& name : names) {
        double sums[2] = {}, squares[2] = {}, errors[2] = {};
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            EvaluationOptions options = sobol(2'000);
            options.trials = 1'000;
            options.seed = seed;
            const auto result = evaluate(model, inputs, options);
            ASSERT_TRUE(result);
            const SobolIndex& s = index_of(*result, name);
            const double value[2] = {s.first, s.total};
            const double error[2] = {s.first_standard_error, s.total_standard_error};
            for (int k = 0; k < 2; ++k)
                sums[k] += value[k], squares[k] += value[k] * value[k], errors[k] += error[k] * error[k];
        }
        for (int k = 0; k < 2; ++k) {
            const double scatter = std::sqrt(squares[k] / seeds - std::pow(sums[k] / seeds, 2));
            const double stated = std::sqrt(errors[k] / seeds);
            EXPECT_NEAR(stated / scatter, 1.0, 4.0 / std::sqrt(2.0 * seeds)) << name << " " << k;
        }
    }
}

TEST(Sobol, SameBitsForAnyNumberOfThreads) {
    InputSet inputs;
    for (const char* name : {"a", "b", "c"}) add_quantity(inputs, name, Distribution::normal(1), infinity);
    RunControl one, two;
    one.threads = 1;
    two.threads = 2;
    const auto first = evaluate(sum_model(inputs), inputs, sobol(5'500), one);
    const auto second = evaluate(sum_model(inputs), inputs, sobol(5'500), two);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(first->sobol[0][i].first, second->sobol[0][i].first);
        EXPECT_EQ(first->sobol[0][i].total, second->sobol[0][i].total);
    }
}

TEST(Sobol, IsLeftOutUnlessAskedFor) {
    InputSet inputs;
    add_quantity(inputs, "a", Distribution::normal(1), infinity);
    EXPECT_TRUE(evaluate(sum_model(inputs), inputs, sobol(0))->sobol.empty());
    EXPECT_FALSE(evaluate(sum_model(inputs), inputs, sobol(50)));
}

}  // namespace
}  // namespace covaria::test::sobol_test
