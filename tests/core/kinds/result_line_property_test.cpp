// Every output of every shipped analysis, by each method: U, interval, coverage factor and verdict belong
// together; figures and units of the set-up do with the result what they must.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/base/resource_path.h"
#include "core/math/special_quantiles.h"
#include "core/propagation/engine.h"
#include "core/propagation/evaluate_summary.h"
#include "core/propagation/requirements.h"
#include "core/propagation/reverse_budget.h"
#include "core/result/result_line.h"
#include "tests/core/made.h"
#include "tests/core/shipped_projects.h"

namespace covaria::result_line_property_test {
namespace {

namespace fs = std::filesystem;
using Prepared = std::shared_ptr<const PreparedAnalysis>;

std::vector<Prepared> analyses_of(const Project& project) {
    Problems problems;
    std::vector<Prepared> all;
    for (const AnalysisEntry& entry : project.analyses) {
        all.push_back(made_analysis(project, entry.id, problems));
        EXPECT_TRUE(all.back()) << entry.id;
        if (!all.back()) all.pop_back();
    }
    for (const Problem& p : problems.items())
        if (p.severity == Severity::error) ADD_FAILURE() << p.path << " " << p.message.english();
    return all;
}

class ResultLines : public testing::TestWithParam<fs::path> {
protected:
    Project project() const {
        LoadedProject loaded = load_project(GetParam());
        EXPECT_FALSE(loaded.problems.has_errors());
        return loaded.project;
    }
};

EvaluationOptions variant(EvaluationOptions options, Method method, std::optional<double> k) {
    options.method = method;
    options.coverage_factor = k;
    options.trials = 5'000;
    options.maximum_trials = 20'000;
    options.minimum_batches = 2;
    options.tolerance = {};
    options.one_at_a_time_trials = options.contributor_trials = options.sobol_trials = 0;
    return options;
}

UncertaintyResult evaluated(const PreparedAnalysis& analysis, const EvaluationOptions& options) {
    auto result = evaluate(*analysis.model, analysis.inputs, options);
    EXPECT_TRUE(result) << analysis.id << ": " << result.error().message.english();
    return std::move(*result);
}

void expect_line(const OutputResult& y, const UncertaintyResult& result) {
    const double u = y.standard_uncertainty, U = y.expanded_uncertainty;
    const CoverageInterval interval = coverage_interval_of(y, result);
    const double half = 0.5 * (interval.high - interval.low);
    if (result.fixed_coverage_factor) {
        EXPECT_DOUBLE_EQ(U, *result.fixed_coverage_factor * u);
    } else {
        EXPECT_NEAR(U, half, 1e-12 * U + 1e-15 * std::abs(y.estimate));
    }
    if (std::isfinite(u)) {
        EXPECT_NEAR(U, y.coverage_factor * u, 1e-12 * U);
    } else {
        EXPECT_TRUE(std::isnan(y.coverage_factor) || result.fixed_coverage_factor);
    }
    EXPECT_EQ(y.monte_carlo ? y.monte_carlo->standard_uncertainty : y.first_order.standard_uncertainty, u);
}

RequirementResult judged(const UncertaintyResult& result, std::size_t j, std::optional<double> lower,
                         std::optional<double> upper, std::optional<double> target = {}) {
    return judge(result,
                 {.output = j, .target_uncertainty = target, .lower_limit = lower, .upper_limit = upper});
}

/// An angle is in its interval also where a tail of the distribution by the law of propagation is a turn
/// away; trials lie within half a turn.
double from_other_turns(const OutputResult& y, double half) {
    if (!y.quantity.periodic || y.monte_carlo) return 0.0;
    const double turn = 2.0 * std::numbers::pi, u = y.standard_uncertainty;
    const double nu = y.first_order.effective_degrees_of_freedom;
    return 2.0 *
           (t_distribution_function((half - turn) / u, nu) - t_distribution_function((-half - turn) / u, nu));
}

void expect_verdicts(std::size_t j, const UncertaintyResult& result) {
    const OutputResult& y = result.outputs[j];
    const double U = y.expanded_uncertainty;
    if (!(U > 1e-12 * std::abs(y.estimate)) || !std::isfinite(U)) return;
    EXPECT_TRUE(judged(result, j, {}, {}, U * (1 + 1e-9)).meets_target);
    EXPECT_FALSE(judged(result, j, {}, {}, U * (1 - 1e-9)).meets_target);
    using Decision = RequirementResult::Decision;
    const double far = 1.001 * U, near = 0.999 * U;
    EXPECT_EQ(judged(result, j, y.estimate - far, {}).decision, Decision::accept);
    EXPECT_EQ(judged(result, j, y.estimate - near, {}).decision, Decision::reject);
    EXPECT_EQ(judged(result, j, {}, y.estimate + far).decision, Decision::accept);
    EXPECT_EQ(judged(result, j, {}, y.estimate + near).decision, Decision::reject);
    // The interval as tolerance: the probability is that of the interval.
    const CoverageInterval interval = coverage_interval_of(y, result);
    if (y.quantity.periodic && interval.high - interval.low > 6.0) return;
    const double p = judged(result, j, interval.low, interval.high).conformance;
    const double valid = static_cast<double>(result.trials - result.failed_trials);
    // Order statistics are kept 3 % apart: 4 standard deviations of a count in between, at both ends.
    const double kept = 4.0 + 4.0 * std::sqrt(0.5 * 0.03 * 0.5 * (1.0 - result.coverage_probability) * valid);
    EXPECT_NEAR(p, result.coverage_probability + from_other_turns(y, 0.5 * (interval.high - interval.low)),
                y.monte_carlo ? kept / valid : 1e-9);
}

TEST_P(ResultLines, UAndIntervalAndVerdictAgree) {
    for (const Prepared& analysis : analyses_of(project()))
        for (const Method method : {Method::first_order, Method::monte_carlo, Method::adaptive})
            for (const std::optional<double> k : {std::optional<double>(), std::optional<double>(2.5)}) {
                const auto options = variant(analysis->options, method, k);
                const UncertaintyResult result = evaluated(*analysis, options);
                for (std::size_t j = 0; j < result.outputs.size(); ++j) {
                    SCOPED_TRACE(analysis->id + " " + result.outputs[j].quantity.symbol + " " +
                                 result.outputs[j].quantity.group + " method " +
                                 std::to_string(static_cast<int>(method)));
                    expect_line(result.outputs[j], result);
                    expect_verdicts(j, result);
                }
            }
}

// A study states what the run states.
TEST_P(ResultLines, SummariesStateTheSame) {
    for (const Prepared& analysis : analyses_of(project()))
        for (const Method method : {Method::first_order, Method::monte_carlo}) {
            const auto options = variant(analysis->options, method, {});
            const UncertaintyResult result = evaluated(*analysis, options);
            std::vector<std::size_t> outputs(std::min<std::size_t>(result.outputs.size(), 6));
            for (std::size_t j = 0; j < outputs.size(); ++j) outputs[j] = j;
            const auto summary = evaluate_summary(*analysis->model, analysis->inputs, outputs, options,
                                                  [](std::uint64_t) { return true; });
            ASSERT_TRUE(summary) << summary.error().message.english();
            for (std::size_t j = 0; j < outputs.size(); ++j) {
                const OutputResult& y = result.outputs[j];
                const double U = summary->expanded_uncertainty(static_cast<Eigen::Index>(j));
                EXPECT_NEAR(U, y.expanded_uncertainty, 1e-9 * y.expanded_uncertainty)
                    << analysis->id << " " << y.quantity.symbol;
            }
        }
}

TEST_P(ResultLines, DoublingEveryUDoublesFirstOrder) {
    for (const Prepared& analysis : analyses_of(project())) {
        const auto options = variant(analysis->options, Method::first_order, {});
        InputSet doubled = analysis->inputs;
        for (InputQuantity& quantity : doubled.quantities)
            for (Share& share : quantity.shares) scale_share(doubled, quantity, share, 2.0);
        const UncertaintyResult before = evaluated(*analysis, options);
        const auto after = evaluate(*analysis->model, doubled, options);
        ASSERT_TRUE(after) << after.error().message.english();
        for (std::size_t j = 0; j < before.outputs.size(); ++j) {
            const OutputResult &a = before.outputs[j], &b = after->outputs[j];
            const double rounding = 1e-9 * a.standard_uncertainty;
            EXPECT_NEAR(b.estimate, a.estimate, rounding + 1e-12 * std::abs(a.estimate));
            EXPECT_NEAR(b.standard_uncertainty, 2 * a.standard_uncertainty, 2 * rounding) << analysis->id;
            EXPECT_NEAR(b.expanded_uncertainty, 2 * a.expanded_uncertainty, 1e-8 * a.expanded_uncertainty)
                << analysis->id;
        }
    }
}

// The figure of the reverse budget, put in, meets the target by the law of propagation.
TEST_P(ResultLines, TheReverseBudgetMeetsItsTarget) {
    for (const Prepared& analysis : analyses_of(project())) {
        const auto options = variant(analysis->options, Method::first_order, {});
        const UncertaintyResult result = evaluated(*analysis, options);
        const double U = result.outputs[0].expanded_uncertainty, target = 0.9 * U;
        if (!(U > 0.0)) continue;
        const auto budget = reverse_budget(nullptr, result, 0, target);
        ASSERT_TRUE(budget) << budget.error().message.english();
        ASSERT_FALSE(budget->reductions.empty()) << analysis->id;
        for (const ReverseBudget::Reduction& reduction : budget->reductions) {
            InputSet changed = analysis->inputs;
            scale_component(changed, reduction.component, reduction.factor().value_or(0.0));
            const auto after = evaluate(*analysis->model, changed, options);
            ASSERT_TRUE(after) << after.error().message.english();
            const double reached = after->outputs[0].expanded_uncertainty;
            if (reduction.needed)
                EXPECT_NEAR(reached, target, 1e-7 * target) << analysis->id;
            else
                EXPECT_GT(reached, target) << analysis->id;
        }
        EXPECT_TRUE(budget->common_factor || std::any_of(budget->reductions.begin(), budget->reductions.end(),
                                                         [](const auto& r) { return r.needed.has_value(); }));
    }
}

/// The coherent SI unit of the same dimension, where there is a short one. A temperature keeps its own.
Unit coherent(const Unit& unit) {
    if (unit.to_si(0.0) != 0.0) return unit;
    for (const char* text :
         {"m", "rad", "kg", "s", "A", "V", "N", "N*m", "Pa", "1/K", "kg/m^3", "rad/m", "m/N"})
        if (Unit::of(text).dimension() == unit.dimension()) return Unit::of(text);
    return unit;
}

void convert_column(SetupTable& table, std::size_t column) {
    const Unit from = table.units[column], to = coherent(from);
    table.units[column] = to;
    for (auto& row : table.rows)
        if (column < row.size())
            if (double* number = std::get_if<double>(&row[column])) *number = to.from_si(from.to_si(*number));
}

std::size_t to_coherent_units(Setup& setup) {
    std::size_t changed = 0;
    for (auto& [key, value] : setup.values) {
        if (auto* quantity = std::get_if<Quantity>(&value)) {
            const Unit unit = coherent(quantity->unit);
            changed += unit == quantity->unit ? 0 : 1;
            *quantity = {unit.from_si(quantity->si()), unit};
        } else if (auto* pose = std::get_if<PoseValue>(&value)) {
            for (double& x : pose->position) x = pose->length_unit.to_si(x);
            for (double& angle : pose->angles) angle = pose->angle_unit.to_si(angle);
            pose->length_unit = Unit::of("m");
            pose->angle_unit = Unit::of("rad");
            ++changed;
        } else if (auto* table = std::get_if<SetupTable>(&value)) {
            for (std::size_t column = 0; column < table->units.size(); ++column) {
                changed += coherent(table->units[column]) == table->units[column] ? 0 : 1;
                convert_column(*table, column);
            }
        }
    }
    return changed;
}

// Metres instead of millimetres, radians instead of degrees: the same result.
TEST_P(ResultLines, UnitsOfTheSetUpLeaveResultsAlone) {
    const Project before = project();
    Project after = before;
    for (AssetEntry& asset : after.assets) to_coherent_units(asset.setup);
    for (AnalysisEntry& analysis : after.analyses) to_coherent_units(analysis.setup);
    const auto first = analyses_of(before), second = analyses_of(after);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const auto options = variant(first[i]->options, Method::first_order, {});
        const UncertaintyResult a = evaluated(*first[i], options), b = evaluated(*second[i], options);
        ASSERT_EQ(a.outputs.size(), b.outputs.size());
        for (std::size_t j = 0; j < a.outputs.size(); ++j) {
            const OutputResult &x = a.outputs[j], &y = b.outputs[j];
            EXPECT_NEAR(y.estimate, x.estimate, 1e-6 * x.standard_uncertainty + 1e-11 * std::abs(x.estimate))
                << first[i]->id << " " << x.quantity.symbol;
            EXPECT_NEAR(y.expanded_uncertainty, x.expanded_uncertainty, 1e-7 * x.expanded_uncertainty)
                << first[i]->id << " " << x.quantity.symbol << " " << x.quantity.group;
        }
    }
}

// JCGM 100 H.1 (U99 = 93 nm) and H.5 (U = 4.1e-5 V at 95 %), by both methods.
TEST(ResultLine, OfTheGum) {
    const auto line = [](const char* file, std::size_t index, const char* symbol, Method method) {
        const LoadedProject loaded = load_project(data_directory() / "projects" / "gum" / file);
        const Prepared analysis = analyses_of(loaded.project).at(index);
        EvaluationOptions options = analysis->options;
        options.method = method;
        options.sobol_trials = options.one_at_a_time_trials = options.contributor_trials = 0;
        const UncertaintyResult result = evaluated(*analysis, options);
        for (const OutputResult& y : result.outputs)
            if (y.quantity.symbol == symbol) return y.expanded_uncertainty;
        ADD_FAILURE() << "no output " << symbol;
        return 0.0;
    };
    for (const Method method : {Method::first_order, Method::monte_carlo})
        EXPECT_NEAR(line("h5-zener.covaria", 0, "V", method), 4.1e-5, 0.05e-5);
    // The table takes delta_theta as t distributed with two degrees of freedom, whose tails at 99 % are far
    // out in Monte Carlo; the statements give its limits.
    EXPECT_NEAR(line("h1-end-gauge.covaria", 0, "l", Method::first_order), 93e-9, 1e-9);
    EXPECT_NEAR(line("h1-end-gauge.covaria", 1, "l", Method::monte_carlo), 93e-9, 2e-9);
}

INSTANTIATE_TEST_SUITE_P(Projects, ResultLines, testing::ValuesIn(shipped_projects()), test_name_of);

}  // namespace
}  // namespace covaria::result_line_property_test
