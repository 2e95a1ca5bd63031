// Identification by joint trajectories on projects/er10l-c10.covaria: recovery, standard deviations and
// correlation of wen.md section 5, what is refused or warned of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/core/kinds/robot/robot_project.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_circle_points_test {
namespace {

using robot_test::Robot;

constexpr const char* simulated = "trajectories-simulated";

/// Estimate or u of every output by symbol, in mm and degrees.
std::map<std::string, double> by_symbol(const UncertaintyResult& r, bool u) {
    std::map<std::string, double> found;
    for (const OutputResult& y : r.outputs)
        found[y.quantity.symbol] =
            y.quantity.unit.interval_from_si(u ? y.first_order.standard_uncertainty : y.first_order.estimate);
    return found;
}

TEST(CirclePoints, NoiseFreePointsGiveTheParametersBack) {
    Robot robot;
    const auto found = by_symbol(robot.run(simulated, 0), false);
    const std::map<std::string, double> calibrated{
        {"a_1", 166.5975},   {"alpha_1", -90.0003}, {"theta_2", -90.062}, {"a_2", 780.26},
        {"alpha_2", -.0261}, {"beta_2", .0234},     {"theta_3", -.1825},  {"d_3", .7937},
        {"a_3", 140.3917},   {"alpha_3", -89.981},  {"theta_4", -.3125},  {"d_4", 1059.7833},
        {"a_4", .1621},      {"alpha_4", 90.0605},  {"theta_5", -.5217},  {"d_5", .7176},
        {"a_5", .1015},      {"alpha_5", -90.015}};
    for (const auto& [symbol, value] : calibrated) {
        ASSERT_TRUE(found.contains(symbol)) << symbol;
        EXPECT_NEAR(found.at(symbol), value, 1e-9) << symbol;
    }
    EXPECT_EQ(found.size(), 18u + 6u) << "18 parameters and 6 radii, nothing else";
    const double radii[] = {1390, 1584, 1244, 101, 183, 100};
    for (int j = 0; j < 6; ++j) EXPECT_NEAR(found.at("R_" + std::to_string(j + 1)), radii[j], 1.0) << j;
}

// The nominal arm: axes 2 and 3 exactly parallel, wrist axes that intersect (a = 0, the sides of x follow the
// nominal frames). With link 2 turned over, alpha_2 is a half turn.
TEST(CirclePoints, ParallelIntersectingAndOpposingAxesAreRecovered) {
    for (const double alpha_2 : {0.0, 180.0}) {
        Robot robot;
        robot.setup(simulated).values["nominal"] = std::string("er10l-nominal");
        SetupTable& joints = robot.asset_table("er10l-nominal", "joints");
        joints.rows[1][3] = alpha_2;
        const auto found = by_symbol(robot.run(simulated, 0), false);
        EXPECT_NEAR(std::remainder(found.at("alpha_2") - alpha_2, 360.0), 0.0, 1e-9);
        EXPECT_NEAR(found.at("beta_2"), 0.0, 1e-9);
        EXPECT_NEAR(found.at("theta_2"), -90.0, 1e-9);
        EXPECT_NEAR(found.at("a_2"), 780.0, 1e-9);
        EXPECT_NEAR(found.at("theta_3"), 0.0, 1e-9);
        EXPECT_NEAR(found.at("a_3"), 140.0, 1e-9);
        EXPECT_NEAR(found.at("d_4"), 1060.0, 1e-9);
        EXPECT_NEAR(found.at("a_5"), 0.0, 1e-9);
        EXPECT_NEAR(found.at("alpha_4"), 90.0, 1e-9);
    }
}

// Table 4 as a sweep: reference values from 300 repetitions, 4 % each; the law of propagation has no noise.
TEST(CirclePoints, StandardUncertaintyAgainstRange) {
    struct {
        double range, theta_3, d_3, a_3, d_4, a_1, alpha_3, alpha_4, alpha_5, beta_2;
    } const rows[] = {{10, .222, 3.33, 4.63, .780, .622, .155, .192, .198, .0111},
                      {20, .0528, .822, 1.14, .204, .166, .0383, .0502, .0515, .0028},
                      {30, .0239, .370, .512, .0912, .0746, .0171, .0221, .0242, .0013},
                      {40, .0136, .209, .285, .0496, .0416, .0097, .0132, .0137, .0008},
                      {60, .0063, .101, .131, .0226, .0213, .0049, .0061, .0064, .0004}};
    for (const auto& row : rows) {
        Robot robot;
        robot.setup(simulated).values["half_range"] = Quantity{row.range, Unit::of("deg")};
        const auto u = by_symbol(robot.run(simulated, 0), true);
        const std::pair<const char*, double> expected[] = {
            {"theta_3", row.theta_3}, {"d_3", row.d_3},         {"a_3", row.a_3},
            {"d_4", row.d_4},         {"a_1", row.a_1},         {"alpha_3", row.alpha_3},
            {"alpha_4", row.alpha_4}, {"alpha_5", row.alpha_5}, {"beta_2", row.beta_2}};
        for (const auto& [symbol, value] : expected) {
            const double rounding = value < .001 ? 6e-5 : value < .01 ? 6e-5 : 0.0;
            EXPECT_NEAR(u.at(symbol), value, .16 * value + rounding) << symbol << " at " << row.range;
        }
    }
}

TEST(CirclePoints, StandardUncertaintyAgainstTheNumberOfPoints) {
    for (const auto& [count, d_3, alpha_4] :
         {std::tuple(10.0, .200, .0118), std::tuple(100.0, .077, .0046)}) {
        Robot robot;
        robot.setup(simulated).values["point_count"] = Quantity{count, Unit()};
        const auto u = by_symbol(robot.run(simulated, 0), true);
        EXPECT_NEAR(u.at("d_3"), d_3, .16 * d_3);
        EXPECT_NEAR(u.at("alpha_4"), alpha_4, .16 * alpha_4);
    }
}

TEST(CirclePoints, MonteCarloAgreesAndShowsTheCorrelation) {
    Robot robot;
    const UncertaintyResult r = robot.run(simulated, 20'000);
    EXPECT_EQ(r.failed_trials, 0u);
    std::map<std::string, Eigen::Index> index;
    for (std::size_t j = 0; j < r.outputs.size(); ++j) {
        index[r.outputs[j].quantity.symbol] = static_cast<Eigen::Index>(j);
        EXPECT_NEAR(
            r.outputs[j].monte_carlo->standard_uncertainty / r.outputs[j].first_order.standard_uncertainty,
            1.0, 4.0 * std::sqrt(.5 / 20'000))
            << r.outputs[j].quantity.symbol;
    }
    const Eigen::MatrixXd R = correlation_of(r.covariance.whole());
    const std::tuple<const char*, const char*, double> expected[] = {{"d_3", "alpha_3", -.987},
                                                                     {"theta_3", "a_3", .985},
                                                                     {"a_3", "a_4", -.869},
                                                                     {"d_3", "a_3", -.851},
                                                                     {"d_3", "alpha_4", .796}};
    for (const auto& [a, b, value] : expected)  // 300 repetitions: standard error (1 − r²)/√300
        EXPECT_NEAR(R(index[a], index[b]), value,
                    4.0 * (1 - value * value) * std::sqrt(1.0 / 300 + 1.0 / 20'000) + 1e-3)
            << a << b;
}

// End effector with the full covariance .018 .013 .020 mm; ignoring it .042 .158 .216 (4 % each).
TEST(CirclePoints, TheIdentifiedRobotCarriesItsCovariance) {
    Robot robot;
    const auto u = robot_test::u(robot.run("zero-pose-identified", 0));
    const double full[] = {.018, .013, .020}, alone[] = {.042, .158, .216};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(u[i], full[i], .16 * full[i] + .0005) << i;
    const auto ignored = robot_test::u_without_correlation(robot, "trajectories");
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(ignored[i], alone[i], .16 * alone[i] + .0005) << i;
    robot.setup("zero-pose-identified").values["correlation"] = std::string("ignored");
    EXPECT_EQ(robot_test::u(robot.run("zero-pose-identified", 0)), u);
    EXPECT_NE(robot.words().find("cannot be ignored"), std::string::npos) << robot.words();
}

TEST(CirclePoints, SyntheticPointsLeadNearTheCalibratedArm) {
    Robot robot;
    const auto y = robot_test::estimates_first_order(robot.run("zero-pose-identified", 0));
    EXPECT_NEAR(y[0], 1349.914155, 4 * .018);
    EXPECT_NEAR(y[1], 1.416990, 4 * .013);
    EXPECT_NEAR(y[2], 1431.103847, 4 * .020);
}

// --- structure and edge cases

bool says(const Robot& robot, const std::string& words) {
    return robot.words().find(words) != std::string::npos;
}

TEST(CirclePoints, NearlyParallelAxesAreRecognised) {
    Robot robot;
    for (auto& row : robot.asset_table("er10l-nominal", "joints").rows) row[4] = SetupCell{};  // no beta
    robot.asset_table("er10l-nominal", "uncertainties").rows.clear();
    const auto prepared = robot.prepare("trajectories");
    ASSERT_NE(prepared, nullptr) << robot.words();
    EXPECT_TRUE(says(robot, "joints 2 and 3 are nearly parallel")) << robot.words();
    for (const OutputQuantity& y : prepared->model->outputs())
        EXPECT_NE(y.symbol, "d_2") << "851 m by the common perpendicular";
}

TEST(CirclePoints, WhatCannotBeIdentifiedIsNamed) {
    Robot robot;
    const auto prepared = robot.prepare(simulated);
    ASSERT_NE(prepared, nullptr);
    std::set<std::string> names;
    const Table missing = prepared->model->evaluation().at(2);
    for (const auto& row : test::rows_of(missing)) names.insert(english_of(row[0]));
    EXPECT_EQ(names,
              (std::set<std::string>{"theta_1", "d_1", "d_2", "theta_6", "d_6", "a_6", "alpha_6", "tool"}));
}

TEST(CirclePoints, ABallOnAnAxisDrawsNoCircle) {
    Robot robot;
    robot.setup(simulated).values["ball"] = PoseValue{};
    EXPECT_EQ(robot.prepare(simulated), nullptr);
    EXPECT_TRUE(says(robot, "axis of that joint and draws no circle")) << robot.words();
    EXPECT_TRUE(says(robot, "joint 6")) << robot.words();
}

TEST(CirclePoints, AShortArcIsWarnedOf) {
    Robot robot;
    robot.setup(simulated).values["half_range"] = Quantity{5.0, Unit::of("deg")};
    ASSERT_NE(robot.prepare(simulated), nullptr) << robot.words();
    EXPECT_TRUE(says(robot, "is short for the uncertainty")) << robot.words();
    robot.setup(simulated).values["half_range"] = Quantity{1.0, Unit::of("deg")};
    EXPECT_EQ(robot.prepare(simulated), nullptr);
    EXPECT_TRUE(says(robot, "straight line")) << robot.words();
}

TEST(CirclePoints, EquationOneFailsForPlanesThroughTheOrigin) {
    Robot robot;
    auto& values = robot.setup(simulated).values;
    values["plane"] = std::string("equation-1");
    values["ball"] = PoseValue{.position = {80.0, 0.0, 40.0}};
    robot.prepare(simulated);
    EXPECT_TRUE(says(robot, "Use total least squares")) << robot.words();
}

TEST(CirclePoints, PointsInTheOtherOrderAreNoticed) {
    Robot robot;
    SetupTable& points = robot.table("trajectories", "points");
    for (auto& row : points.rows) row[1] = SetupCell{};
    std::reverse(points.rows.begin() + 150, points.rows.begin() + 200);
    EXPECT_EQ(robot.prepare("trajectories"), nullptr);
    EXPECT_TRUE(says(robot, "joint 4 run against")) << robot.words();
}

TEST(CirclePoints, TwoPointsAreNoCircle) {
    Robot robot;
    SetupTable& points = robot.table("trajectories", "points");
    points.rows.erase(points.rows.begin() + 2, points.rows.begin() + 50);
    EXPECT_EQ(robot.prepare("trajectories"), nullptr);
    EXPECT_TRUE(says(robot, "joint 1 has 2 points")) << robot.words();
}

// The layout has one point of each trajectory, and the number of them all.
TEST(CirclePoints, TheLayoutSaysHowManyPointsHaveAnUncertainty) {
    Robot robot;
    const auto prepared = robot.prepare("trajectories");
    ASSERT_TRUE(prepared);
    const Layout layout = prepared->model->layout({});
    const auto measured = std::ranges::count(layout.points, PointKind::target, &LayoutPoint::kind);
    const auto shown = std::ranges::count_if(
        layout.points, [](const LayoutPoint& point) { return point.inputs.has_value(); });
    EXPECT_EQ(shown, 6);
    EXPECT_GT(measured, shown);
    EXPECT_EQ(layout.uncertain_points, static_cast<std::size_t>(measured));
}

}  // namespace
}  // namespace covaria::robot_circle_points_test
