// The template of a tracker at several places: its figures as the residuals see them, and calibrated lengths
// that are held back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evidence/seen.h"
#include "core/kinds/registries.h"
#include "core/made/analysis_templates.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::network_method_test {
namespace {

using evidence::Verdict;

struct NetworkMethod {
    NetworkMethod() {
        const auto wanted =
            std::ranges::find(analysis_templates(), "Network method for a tracker", &AnalysisTemplate::title);
        project = template_project(*wanted).value();
        id = project.analyses.back().id;
    }
    SetupTable& table(const char* key) {
        return std::get<SetupTable>(project.analyses.back().setup.values.at(key));
    }
    std::shared_ptr<const PreparedAnalysis> prepare() {
        problems = {};
        return made_analysis(project, id, problems);
    }
    bool warns_of(const std::string& words) const {
        return std::ranges::any_of(problems.items(), [&](const Problem& problem) {
            return problem.message.english().find(words) != std::string::npos;
        });
    }

    Project project;
    std::string id;
    Problems problems;
};

std::vector<std::vector<Cell>> held_lengths(const PreparedAnalysis& prepared) {
    for (const Table& table : prepared.model->evaluation())
        if (table.id == "check-lengths") return test::rows_of(table);
    return {};
}

double number(const Cell& cell) {
    return std::get<Measured>(cell).si;
}

/// The truth is what the readings of the example were simulated with.
TEST(NetworkMethod, SeesTheFiguresOfTheTracker) {
    NetworkMethod method;
    const auto prepared = method.prepare();
    ASSERT_TRUE(prepared && prepared->model);
    EXPECT_FALSE(method.problems.has_errors());
    EXPECT_TRUE(method.warns_of("The residuals are larger than the uncertainties allow"));
    const auto readings = prepared->model->redundant_readings();
    ASSERT_TRUE(readings);
    const evidence::Seen& seen = evidence::seen_of(*readings);
    ASSERT_TRUE(seen.found);
    ASSERT_EQ(readings->figures.size(), 3u);
    const std::vector<std::tuple<const char*, double, Verdict>> truth{
        {"directions of LT", 0.42 / 0.3, Verdict::larger},
        {"zenith angles of LT", 0.31 / 0.3, Verdict::agrees},
        {"slope distances of LT", 0.0065 / 0.01, Verdict::agrees}};  // redundancy 19 does not tell .65 from 1
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const auto& [name, factor, verdict] = truth[k];
        const evidence::SeenFigure& figure = seen.figures[k];
        EXPECT_EQ(readings->figures[k].name.english(), name);
        EXPECT_GE(figure.redundancy, evidence::least_redundancy) << name;
        EXPECT_LE(figure.low, factor) << name;
        EXPECT_GE(figure.high, factor) << name;
        EXPECT_EQ(figure.verdict, verdict) << name;
    }
    // Zero of distances and index of zenith angles, which are unknown.
    const UncertaintyResult result = run_analysis(*prepared).value();
    for (const auto& [symbol, of_truth] :
         {std::pair("c_LT", 0.021e-3), std::pair("i_LT", 0.0007 * std::acos(-1.0) / 200.0)}) {
        const auto found = std::ranges::find(
            result.outputs, symbol, [](const OutputResult& output) { return output.quantity.symbol; });
        ASSERT_NE(found, result.outputs.end()) << symbol;
        const FirstOrderOutput& figure = found->first_order;
        EXPECT_NEAR(figure.estimate, of_truth, 3.0 * figure.standard_uncertainty) << symbol;
        EXPECT_GT(std::abs(figure.estimate), 2.0 * figure.standard_uncertainty) << symbol;
    }
}

TEST(NetworkMethod, HoldsCalibratedLengthsAgainstItsDistances) {
    NetworkMethod method;
    const auto prepared = method.prepare();
    ASSERT_TRUE(prepared && prepared->model);
    const UncertaintyResult result = run_analysis(*prepared).value();
    const auto rows = held_lengths(*prepared);
    const SetupTable& stated = method.table("distances");
    ASSERT_EQ(rows.size(), 2u);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const OutputResult& distance = result.outputs[result.outputs.size() - rows.size() + k];
        EXPECT_EQ(std::get<std::string>(rows[k][0]), distance.quantity.symbol);
        const double reference = 1e-3 * std::get<double>(stated.rows[k][2]);
        const double U = 2.0 * std::hypot(distance.first_order.standard_uncertainty,
                                          1e-3 * std::get<double>(stated.rows[k][3]));
        const double d = distance.first_order.estimate - reference;
        EXPECT_NEAR(number(rows[k][3]), d, 1e-6 * U);
        EXPECT_NEAR(number(rows[k][4]), U, 1e-6 * U);
        EXPECT_NEAR(number(rows[k][5]), std::abs(d) / U, 1e-6);
        EXPECT_LT(number(rows[k][5]), 1.0);
    }
}

/// Residuals of a free network do not know the scale of its distances; a length that is held back does.
TEST(NetworkMethod, TellsAWrongScaleThatNoResidualSees) {
    NetworkMethod method;
    const auto right = evidence::global_test(*method.prepare()->model->redundant_readings());
    SetupTable& readings = method.table("readings");
    const auto& columns = find_model("network-adjustment")->schema.find("readings")->columns;
    const auto length = std::ranges::find(columns, "length", &ColumnSpec::key) - columns.begin();
    for (auto& row : readings.rows)
        if (auto* value = std::get_if<double>(&row[static_cast<std::size_t>(length)])) *value *= 1.0 + 2e-5;
    const auto prepared = method.prepare();
    ASSERT_TRUE(prepared && prepared->model);
    EXPECT_NEAR(evidence::global_test(*prepared->model->redundant_readings()).s0, right.s0, 1e-3 * right.s0);
    EXPECT_TRUE(method.warns_of("as adjusted differs from its reference by"));
    EXPECT_GT(number(held_lengths(*prepared)[1][5]), 5.0);
}

TEST(NetworkMethod, AReferenceNeedsItsUncertainty) {
    NetworkMethod method;
    method.table("distances").rows[0][3] = std::monostate();
    EXPECT_FALSE(method.prepare());
    EXPECT_TRUE(method.warns_of("a reference length and its u belong together"));
}

}  // namespace
}  // namespace covaria::network_method_test
