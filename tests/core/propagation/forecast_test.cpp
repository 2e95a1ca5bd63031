// The forecast of an adaptive run: JCGM 101 7.9 for normal outputs (wen.md section 4).
#include "core/propagation/forecast.h"

#include <gtest/gtest.h>

#include "core/propagation/engine.h"
#include "core/result/uncertainty_result.h"
#include "tests/core/propagation/test_models.h"

namespace covaria::forecast_test {
using namespace test;

namespace {

EvaluationOptions adaptive(double tolerance, const char* unit) {
    EvaluationOptions options;
    options.method = Method::adaptive;
    options.tolerance = Quantity{tolerance, Unit::of(unit)};
    return options;
}

// N = 28.54 (u/delta)²: u = 1.3687 and delta = 0.0001 need 5.35e9 trials.
TEST(Forecast, TheEndPointsGovern) {
    const auto inputs = normal_inputs({{0, 1.3687}});
    const auto model = sum_model(inputs);
    const auto found = forecast_adaptive(model, *propagate(model, inputs), adaptive(0.0001, "1"));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->trials, 5.35e9, .01e9);
    EXPECT_NEAR(found->batches, 535'000, 1000);
    EXPECT_NE(found->words().english().find("5300000000 trials"), std::string::npos)
        << found->words().english();
    const std::string read = found->words().in([](const std::string& english) { return english; },
                                               [](const std::string& plain) { return "<" + plain + ">"; });
    for (const char* number : {"<0.0001>", "<1.4>", "<5300000000>", "<530000>"})
        EXPECT_NE(read.find(number), std::string::npos)
            << number << " is written as its reader writes: " << read;
}

TEST(Forecast, ARunStopsNearIt) {
    const auto inputs = normal_inputs({{0, 1.0}});
    const auto model = sum_model(inputs);
    const EvaluationOptions options = adaptive(0.01, "1");
    const auto found = forecast_adaptive(model, *propagate(model, inputs), options);
    const auto result = evaluate(model, inputs, options);
    ASSERT_TRUE(found && result);
    EXPECT_GT(static_cast<double>(result->trials), .5 * found->trials);
    EXPECT_LT(static_cast<double>(result->trials), 2.0 * found->trials);
}

TEST(Forecast, ATolerancesUnitChoosesTheOutputs) {
    const EvaluationOptions options = adaptive(0.005, "mm");
    EXPECT_EQ(options.tolerance_for(Unit::of("mm")), 5e-6);
    EXPECT_EQ(options.tolerance_for(Unit::of("m")), 5e-6);
    EXPECT_FALSE(options.tolerance_for(Unit::of("deg")));
    EXPECT_EQ(adaptive(0.5, "1").tolerance_for(Unit::of("deg")), 0.5);
}

TEST(Forecast, OnlyForTheAdaptiveProcedure) {
    const auto inputs = normal_inputs({{0, 1.0}});
    EvaluationOptions options = adaptive(0.0001, "1");
    options.method = Method::monte_carlo;
    EXPECT_FALSE(forecast_adaptive(sum_model(inputs), *propagate(sum_model(inputs), inputs), options));
}

// Two groups: contributions combine in quadrature, shares add.
TEST(Contributions, ByGroup) {
    auto inputs = normal_inputs({{0, 3.0}, {0, 4.0}, {0, 12.0}});
    inputs.quantities[0].tags = {{"joint", "one"}};
    inputs.quantities[1].tags = {{"joint", "one"}};
    EvaluationOptions options;
    options.method = Method::first_order;
    const auto result = evaluate(sum_model(inputs), inputs, options);
    ASSERT_TRUE(result);
    ASSERT_EQ(groupings_of(result->budget), std::vector<std::string>{"joint"});
    const auto groups = contributions_by_group(result->budget, 0, "joint");
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].group, "other");
    EXPECT_NEAR(groups[0].contribution, 12.0, 1e-12);
    EXPECT_NEAR(groups[1].contribution, 5.0, 1e-12);
    EXPECT_NEAR(groups[1].share, 25.0 / 169.0, 1e-12);
}

}  // namespace
}  // namespace covaria::forecast_test
