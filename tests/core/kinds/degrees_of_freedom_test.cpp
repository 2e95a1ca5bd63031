// Degrees of freedom over all examples: from the set-up to first order and to the draws.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <set>

#include "core/base/resource_path.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/shipped_projects.h"

namespace covaria::degrees_of_freedom_test {
namespace {

/// Every analysis of the shipped examples.
void each_analysis(const std::function<void(const PreparedAnalysis&)>& use) {
    for (const std::filesystem::path& file : shipped_projects()) {
        const Project project = load_project(file).project;
        Problems problems;
        for (const AnalysisEntry& analysis : project.analyses)
            if (const auto prepared = made_analysis(project, analysis.id, problems)) use(*prepared);
    }
}

TEST(DegreesOfFreedom, OfAllExamplesAreDrawn) {
    std::size_t found = 0;
    each_analysis([&](const PreparedAnalysis& analysis) {
        for (const UncertaintyComponent& c : analysis.inputs.components) {
            const double nu = degrees_of_freedom_of(c);
            if (std::isinf(nu) || !(c.distribution.standard_uncertainty() > 0.0)) continue;
            ++found;
            const Distribution drawn = drawn_distribution(c);
            EXPECT_EQ(drawn.standard_uncertainty(), c.distribution.standard_uncertainty()) << c.id;
            if (c.normal_draws || c.distribution.kind() != "normal") continue;
            EXPECT_EQ(drawn.degrees_of_freedom(), nu) << analysis.id << ", " << c.id;
        }
    });
    EXPECT_GT(found, 20u);
}

// u^4/nu_eff is a sum over the estimates of variance: nu_eff cannot exceed the sum of their degrees of
// freedom where nothing else contributes, nor fall below their least times the part of the variance that they
// give.
TEST(DegreesOfFreedom, NeverExceedTheSumOverDistinctEstimates) {
    std::size_t finite = 0;
    each_analysis([&](const PreparedAnalysis& analysis) {
        const auto result = evaluate_first_order(*analysis.model, analysis.inputs, analysis.options);
        ASSERT_TRUE(result) << analysis.id;
        const std::vector<std::size_t> estimates = analysis.inputs.estimates_of_components();
        for (std::size_t j = 0; j < result->outputs.size(); ++j) {
            if (result->outputs[j].first_order.standard_uncertainty == 0.0) continue;
            double sum = 0.0, least = infinity;
            std::set<std::size_t> counted;
            for (const BudgetRow& row : result->budget.rows[j]) {
                if (row.contribution == 0.0) continue;
                const double nu = degrees_of_freedom_of(analysis.inputs.components[row.component]);
                least = std::min(least, nu);
                const std::size_t estimate = estimates[row.component];
                if (estimate == InputSet::npos || counted.insert(estimate).second) sum += nu;
            }
            const double nu = result->outputs[j].first_order.effective_degrees_of_freedom;
            EXPECT_LE(nu, sum * (1.0 + 1e-9)) << analysis.id << ", " << result->outputs[j].quantity.symbol;
            EXPECT_GE(nu, least * (1.0 - 1e-9)) << analysis.id << ", " << result->outputs[j].quantity.symbol;
            finite += std::isfinite(nu);
        }
    });
    EXPECT_GT(finite, 20u);
}

// One length standard, n = 4, serves both frames: every output rests on one standard deviation.
TEST(DegreesOfFreedom, OneStandardDeviationThatServesManyPointsCountsOnce) {
    const std::filesystem::path path = COVARIA_SOURCE_DIR "/tests/data/cases/dofshare.covaria";
    const Project project = load_project(path).project;
    Problems problems;
    const auto analysis = made_analysis(project, "one", problems);
    ASSERT_TRUE(analysis);
    EvaluationOptions options;
    options.trials = 200'000;
    const auto result = evaluate(*analysis->model, analysis->inputs, options);
    ASSERT_TRUE(result) << result.error().message.english();
    for (const OutputResult& output : result->outputs) {
        EXPECT_NEAR(output.first_order.effective_degrees_of_freedom, 3.0, 1e-9) << output.quantity.symbol;
        EXPECT_NEAR(output.first_order.coverage_factor, 3.182, 5e-4);
        const CoverageInterval& interval = output.monte_carlo->symmetric;
        EXPECT_NEAR(0.5 * (interval.high - interval.low),
                    output.first_order.coverage_factor * output.first_order.standard_uncertainty,
                    0.03 * output.first_order.coverage_factor * output.first_order.standard_uncertainty)
            << output.quantity.symbol << ": the interval of Monte Carlo is that of first order";
    }
}

}  // namespace
}  // namespace covaria::degrees_of_freedom_test
