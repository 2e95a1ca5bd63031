// Loads decoupled by the calibration matrix of Kim's sensor: reference values by first order and Monte Carlo,
// quadratic terms, singular matrices.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/kinds/force/force_project.h"

namespace covaria::force_loads_test {
namespace {

using Row = std::vector<double>;

constexpr double rated[] = {100, 100, 100, 1, 1, 1};

bool is_compensated(const OutputResult& y) {
    return y.quantity.role == OutputRole::measurand;
}

/// k = 2, % of rated load.
Row expanded(const UncertaintyResult& r, const std::string& group, bool monte_carlo) {
    Row row;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == group && is_compensated(y))
            row.push_back(
                200.0 *
                (monte_carlo ? y.monte_carlo->standard_uncertainty : y.first_order.standard_uncertainty) /
                rated[row.size()]);
    return row;
}

/// Equal to the reference value when rounded to its last digit.
void expect_rounds_to(const Row& found, const Row& expected, const std::string& what) {
    ASSERT_EQ(found.size(), expected.size()) << what;
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(std::round(found[i] * 1e3) / 1e3, expected[i], 1e-9)
            << what << " " << i << ": " << found[i];
}

const Row no_load = {.149, .159, .144, .188, .179, .180};
const Row mixed = {.158, .162, .148, .195, .194, .184};
const Row all_rated = {.184, .192, .152, .226, .219, .261};

TEST(ForceLoads, FirstOrderIsThatOfTheReference) {
    const UncertaintyResult r = ForceProject().first_order("loads");
    expect_rounds_to(expanded(r, "no load", false), no_load, "no load");
    expect_rounds_to(expanded(r, "mixed", false), mixed, "mixed");
    expect_rounds_to(expanded(r, "all rated", false), all_rated, "all rated");
}

TEST(ForceLoads, MonteCarloAgreesWithTheReference) {
    constexpr double trials = 200'000;
    const UncertaintyResult r = ForceProject().monte_carlo("loads", std::uint64_t(trials));
    EXPECT_EQ(r.failed_trials, 0u);
    for (const auto& [group, reference] :
         {std::pair{"no load", no_load}, {"mixed", mixed}, {"all rated", all_rated}}) {
        const Row found = expanded(r, group, true);
        ASSERT_EQ(found.size(), reference.size());
        for (std::size_t i = 0; i < found.size(); ++i)  // u has the relative standard error 1/sqrt(2 M)
            EXPECT_NEAR(found[i], reference[i], 4.0 * reference[i] / std::sqrt(2.0 * trials) + 5e-4)
                << group << i;
    }
}

TEST(ForceLoads, LoadsAreThoseThatWereGiven) {
    const UncertaintyResult r = ForceProject().first_order("loads");
    const Row given = {50, -30, 80, .4, -.6, .2};
    std::size_t i = 0;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == "mixed" && is_compensated(y)) {
            EXPECT_NEAR(y.estimate, given[i], 1e-12 * rated[i]) << y.quantity.symbol;
            ++i;
        }
    EXPECT_EQ(i, 6u);
}

TEST(ForceLoads, WithoutCompensationTheLoadsAreToldWrong) {
    const Table table = table_with(ForceProject().model_tables("loads"), "loads");
    const Row published = {-0.73, 2.05, -1.42, -2.72, 2.90, -1.54};
    const Row found = numbers(table, 6);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[6 + i], published[i], 0.0051) << i;
}

TEST(ForceLoads, CompensationBeatsThePaper) {
    const Row paper = {.9122, 1.2198, 1.6671, 1.6797, 2.7795, 1.2042};
    const Row compensated = expanded(ForceProject().first_order("loads"), "all rated", false);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_GT(paper[i] / compensated[i], 4.6);
        EXPECT_LT(paper[i] / compensated[i], 13.0);
    }
}

TEST(ForceLoads, TheMatrixIsWellConditioned) {
    const Table table = table_with(ForceProject().model_tables("loads"), "matrix");
    ASSERT_FALSE(table.notes.empty());
    EXPECT_NE(table.notes[0].english().find(": 1.028"), std::string::npos) << table.notes[0];
}

TEST(ForceLoads, AReadingOfOneCalibrationStepIsItsLoad) {
    // Means at 80 N on Fx: the matrix is a fit, so residuals of the calibration remain.
    ForceProject project;
    SetupTable& readings = std::get<SetupTable>(project.analysis("reading").setup.values.at("readings"));
    readings.rows = {{std::string("Fx 80 N"), 0.42224, 0.00375, -0.00339, -0.00415, 0.01305, -0.00418}};
    for (const char* const matrix : {"linear", "quadratic"}) {
        project.analysis("reading").setup.values["matrix"] = std::string(matrix);
        const UncertaintyResult r = project.first_order("reading");
        std::size_t i = 0;
        for (const OutputResult& y : r.outputs) {
            if (!is_compensated(y)) continue;
            EXPECT_NEAR(y.estimate / rated[i], i == 0 ? 0.8 : 0.0, 0.003)
                << matrix << " " << y.quantity.symbol;
            ++i;
        }
    }
}

TEST(ForceLoads, QuadraticTermsAreInverted) {
    ForceProject project;
    // A channel with a strong quadratic term: 5 % of its rated output at rated load.
    project.change_readings({"Fz", "calibration", "", 0}, [&](std::vector<SetupCell>& row) {
        const double l = std::get<double>(row[project.column("load")]) / 100.0;
        double& reading = std::get<double>(row[project.column("Fz")]);
        reading += 0.05 * 0.48 * l * l;
        return true;
    });
    Row linear, quadratic;
    for (const char* const matrix : {"linear", "quadratic"}) {
        project.analysis("loads").setup.values["matrix"] = std::string(matrix);
        const UncertaintyResult r = project.first_order("loads");
        EXPECT_NEAR(r.outputs[2].estimate, 80.0, 1e-9);  // loads are given: they come back
        (matrix == std::string("linear") ? linear : quadratic) = expanded(r, "mixed", false);
    }
    EXPECT_LT(quadratic[2], 0.5 * linear[2]);  // the rest after a straight line is in its regression
    const UncertaintyResult r = project.monte_carlo("loads", 100'000);
    EXPECT_EQ(r.failed_trials, 0u);
    for (const OutputResult& y : r.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                    4.0 / std::sqrt(2e5) + 1e-3)
            << y.quantity.group << y.quantity.symbol;
}

TEST(ForceLoads, ASingularMatrixIsRefused) {
    ForceProject project;  // My answers exactly as Mx does
    project.change_readings({}, [&](std::vector<SetupCell>& row) {
        row[project.column("My")] = row[project.column("Mx")];
        return true;
    });
    // Its own load moves it less than Mx, which the calibration already refuses.
    EXPECT_TRUE(project.refuses("loads", "My")) << project.words();
    ForceProject summary;
    summary.asset("sensor-printed").values["has_signs"] = true;
    summary.analysis("loads").setup.values["sensor"] = std::string("sensor-printed");
    auto& rows = summary.table("sensor-printed", "interference").rows;
    for (std::size_t c = 0; c < 6; ++c)  // Fx = Fy by their rated outputs, and answering alike to all loads
        if (c != 0 && c != 1) rows[1][c + 1] = std::get<double>(rows[0][c + 1]) * 0.47948 / 0.52782;
    rows[0][2] = 0.52782;
    rows[1][1] = 0.47948;
    EXPECT_TRUE(summary.refuses("loads", "singular: the channels answer to loads on 'Fx' and 'Fy' alike"))
        << summary.words();
}

TEST(ForceLoads, InterferenceWithoutSignsCannotBeCompensated) {
    ForceProject project;
    project.analysis("loads").setup.values["sensor"] = std::string("sensor-printed");
    EXPECT_TRUE(project.refuses("loads", "known without signs")) << project.words();
    project.asset("sensor-printed").values["has_signs"] = true;
    EXPECT_TRUE(project.prepare("loads")) << project.words();
    project.analysis("loads").setup.values["matrix"] = std::string("quadratic");
    EXPECT_TRUE(project.refuses("loads", "quadratic terms need raw readings")) << project.words();
}

TEST(ForceLoads, CasesAreChecked) {
    ForceProject none;
    std::get<SetupTable>(none.analysis("loads").setup.values.at("loads")).rows.clear();
    EXPECT_TRUE(none.refuses("loads", "add a row of loads")) << none.words();
    ForceProject twice;
    auto& loads = std::get<SetupTable>(twice.analysis("loads").setup.values.at("loads"));
    loads.rows[1][0] = loads.rows[0][0];
    EXPECT_TRUE(twice.refuses("loads", "two cases are called 'mixed'")) << twice.words();
    ForceProject beyond;
    std::get<SetupTable>(beyond.analysis("loads").setup.values.at("loads")).rows[0][3] = 150.0;
    EXPECT_TRUE(beyond.warns("loads", "the load on Fz is 150 % of its rated load")) << beyond.words();
    ForceProject gap;
    std::get<SetupTable>(gap.analysis("reading").setup.values.at("readings")).rows[0][3] = {};
    EXPECT_TRUE(gap.refuses("reading", "channel Fz has no reading")) << gap.words();
}

TEST(ForceLoads, VectorsCarryTheirUncertainty) {
    ForceProject project;
    const auto prepared = project.prepare("loads");
    ASSERT_TRUE(prepared) << project.words();
    std::vector<double> x;
    for (std::size_t i = 0; i < prepared->inputs.quantities.size(); ++i)
        x.push_back(estimate_of(prepared->inputs, i));
    const Layout layout = prepared->model->layout(x);
    ASSERT_EQ(layout.vectors.size(), 6u);  // force and moment of three cases
    ASSERT_EQ(layout.notes.size(), 1u);
    EXPECT_EQ(layout.notes[0].english(), "results: in the frame of the sensor");
    // The sensor is turned by 90° about z: 50, -30, 80 N and 0.4, -0.6, 0.2 N m along its own axes.
    const LayoutVector &force = layout.vectors[0], &moment = layout.vectors[1];
    EXPECT_LT((force.vector_W - Eigen::Vector3d(30, 50, 80)).norm(), 1e-9);
    EXPECT_LT((moment.vector_W - Eigen::Vector3d(.6, .4, .2)).norm(), 1e-11);
    EXPECT_LT((force.R_WQ * Eigen::Vector3d(50, -30, 80) - force.vector_W).norm(), 1e-9);
    EXPECT_EQ(moment.kind, VectorKind::moment);
    ASSERT_TRUE(force.outputs && moment.outputs);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(prepared->model->outputs()[(*force.outputs)[i]].symbol, std::string("F_") + "xyz"[i]);
        EXPECT_EQ(prepared->model->outputs()[(*moment.outputs)[i]].symbol, std::string("M_") + "xyz"[i]);
    }
}

}  // namespace
}  // namespace covaria::force_loads_test
