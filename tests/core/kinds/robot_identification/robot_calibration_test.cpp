// Identification by least squares on projects/er10l-c10.covaria: recovery, covariance, observability, outlier
// test and validation, what is refused or warned of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/kinds/robot/serial_robot.h"
#include "core/math/rotation.h"
#include "tests/core/kinds/robot/robot_project.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_calibration_test {
namespace {

using robot_test::calibrated;
using robot_test::held_in;
using robot_test::parameters;
using robot_test::Robot;
using robot_test::table_called;

constexpr const char* measured = "poses-measured";
constexpr const char* simulated = "poses-simulated";
constexpr std::size_t first_q = 2, x_column = 9, alpha_column = 12;

/// The poses of the file, seen without deviations: the calibrated arm with its base at X_MB.
void measure_exactly(Robot& robot, const Eigen::Isometry3d& X_MB) {
    const auto asset = robot.asset("er10l-calibrated");
    SetupTable& poses = robot.table(measured, "poses");
    for (auto& row : poses.rows) {
        std::vector<double> q;
        for (std::size_t j = 0; j < 6; ++j)
            q.push_back(std::get<double>(row[first_q + j]) * std::acos(-1.0) / 180.0);
        Eigen::Isometry3d X = X_MB * link_frames(*offers<SerialRobotSource>(asset), q)[6];
        X = X * Eigen::Translation3d(.08, .06, .04);
        const Eigen::Vector3d angles = zyx_from_rotation<double>(X.linear());
        for (int k = 0; k < 3; ++k) {
            row[x_column + static_cast<std::size_t>(k)] = 1e3 * X.translation()[k];
            row[alpha_column + static_cast<std::size_t>(k)] = angles[k] * 180.0 / std::acos(-1.0);
        }
    }
}

Eigen::Isometry3d somewhere() {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = rotation_from_zyx<double>({-.014, .026, 2.6});
    X.translation() = Eigen::Vector3d(2.6, -1.5, -.9);
    return X;
}

TEST(Calibration, ExactPositionsGiveTheParametersBack) {
    Robot robot;
    measure_exactly(robot, somewhere());
    const auto found = parameters(robot.run(measured, 0));
    EXPECT_EQ(found.size(), calibrated.size()) << "nothing else can be found";
    for (const auto& [symbol, value] : calibrated) {
        ASSERT_TRUE(found.contains(symbol)) << symbol;
        EXPECT_NEAR(found.at(symbol).value, value, 1e-8) << symbol;
    }
}

TEST(Calibration, ExactPosesGiveTheParametersBack) {
    Robot robot;
    measure_exactly(robot, somewhere());
    robot.setup(measured).values["quantity"] = std::string("poses");
    const auto found = parameters(robot.run(measured, 0));
    EXPECT_EQ(found.size(), calibrated.size());
    for (const auto& [symbol, value] : calibrated) EXPECT_NEAR(found.at(symbol).value, value, 1e-8) << symbol;
}

// The stated place of the ball is a start: off by some decimetres, or on the axis of the last joint, where it
// would not move with that joint.
TEST(Calibration, AnyStartOfTheBallLeadsToTheSameArm) {
    Robot robot;
    const auto right = parameters(robot.run(measured, 0));
    const std::vector<std::array<double, 3>> starts{{0, 0, 0},       {0, 0, 100},    {0, 0, -200},
                                                    {80, 60, 280},   {-160, 60, 40}, {240, -180, -500},
                                                    {-80, -60, -40}, {0, 1e-6, 0}};
    for (const auto& start : starts) {
        PoseValue ball;
        ball.position = start;
        robot.setup(measured).values["ball"] = ball;
        const auto found = parameters(robot.run(measured, 0));
        EXPECT_TRUE(robot.problems.empty()) << robot.words();
        ASSERT_EQ(found.size(), right.size()) << start[0] << ' ' << start[1] << ' ' << start[2];
        for (const auto& [symbol, parameter] : right) {
            EXPECT_NEAR(found.at(symbol).value, parameter.value, 1e-6 * parameter.u) << symbol;
            EXPECT_NEAR(found.at(symbol).u, parameter.u, 1e-6 * parameter.u) << symbol;
        }
    }
}

TEST(Calibration, AnyStartOfTheToolLeadsToTheSameArm) {
    Robot robot;
    measure_exactly(robot, somewhere());
    robot.setup(measured).values["quantity"] = std::string("poses");
    const std::vector<std::array<double, 3>> turns{{170, 0, 0}, {0, 120, 0}, {-60, 40, 150}, {3, -2, 179}};
    for (const auto& turn : turns) {
        PoseValue tool;
        tool.position = {-200, 300, 0};
        tool.angles = turn;
        robot.setup(measured).values["ball"] = tool;
        const auto found = parameters(robot.run(measured, 0));
        EXPECT_EQ(found.size(), calibrated.size());
        for (const auto& [symbol, value] : calibrated)
            EXPECT_NEAR(found.at(symbol).value, value, 1e-8) << symbol << ' ' << turn[0];
    }
}

TEST(Calibration, SyntheticPositionsLeadToTheCalibratedArm) {
    Robot robot;
    const auto found = parameters(robot.run(measured, 0));
    EXPECT_TRUE(robot.problems.empty()) << robot.words();
    double squares = 0.0;
    for (const auto& [symbol, value] : calibrated) {
        const double z = (found.at(symbol).value - value) / found.at(symbol).u;
        EXPECT_LT(std::abs(z), 4.0) << symbol;
        squares += z * z;
    }
    EXPECT_GT(squares / 18.0, .2) << "u is stated too large";
    EXPECT_LT(found.at("d_3").u, .1);
    EXPECT_LT(found.at("alpha_4").u, .02);
}

TEST(Calibration, MonteCarloAgreesWithItsCovariance) {
    Robot robot;
    const UncertaintyResult r = robot.run(measured, 20'000);
    EXPECT_EQ(r.failed_trials, 0u);
    for (const OutputResult& y : r.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                    4.0 * std::sqrt(.5 / 20'000))
            << y.quantity.group << y.quantity.symbol;
    const Table table = table_called(*robot.prepare(measured), "identified");
    for (const auto& row : test::rows_of(table))
        for (const OutputResult& y : r.outputs)
            if (y.quantity.symbol == english_of(row[0])) {
                EXPECT_NEAR(std::get<Quantity>(row[4]).value,
                            y.quantity.unit.interval_from_si(y.first_order.standard_uncertainty),
                            1e-6 * std::get<Quantity>(row[4]).value);
            }
}

TEST(Calibration, TheIdentifiedRobotCarriesItsCovariance) {
    Robot robot;
    const UncertaintyResult full = robot.run("zero-pose-from-poses", 0);
    const auto y = robot_test::estimates_first_order(full), u = robot_test::u(full);
    const double calibrated_zero[] = {1349.914155, 1.416990, 1431.103847};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(y[i], calibrated_zero[i], 4 * u[i]);
        EXPECT_LT(u[i], .03);
    }
    const auto alone = robot_test::u_without_correlation(robot, "poses-measured");
    EXPECT_GT(std::hypot(alone[0], alone[1], alone[2]), 1.5 * std::hypot(u[0], u[1], u[2]));
}

// --- observability

TEST(Calibration, WhatThePosesCannotTellIsNamedWithItsPartners) {
    Robot robot;
    const auto held = held_in(*robot.prepare(measured));
    std::set<std::string> names;
    for (const auto& [name, reason] : held) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"theta_1", "d_1", "d_2", "theta_6", "d_6", "a_6", "alpha_6"}))
        << "the paper's definitions";
    EXPECT_NE(held.at("theta_1").find("base rotation about z"), std::string::npos) << held.at("theta_1");
    EXPECT_NE(held.at("d_1").find("base z"), std::string::npos) << held.at("d_1");
    EXPECT_NE(held.at("a_6").find("tool x"), std::string::npos) << held.at("a_6");
    EXPECT_NE(held.at("d_2").find("0 by definition"), std::string::npos);
}

TEST(Calibration, AKnownBaseLetsItsParametersBeFound) {
    Robot robot;
    auto& values = robot.setup(simulated).values;
    values["base_place"] = std::string("known");
    const auto found = parameters(robot.run(simulated, 0));
    EXPECT_TRUE(found.contains("theta_1") && found.contains("d_1"));
    EXPECT_FALSE(found.contains("theta_6"));
    values["tool_place"] = std::string("known");
    const auto more = parameters(robot.run(simulated, 0));
    EXPECT_TRUE(more.contains("theta_6"));
    // A circle of joint 6 has a radius, a height and a phase: one of its four parameters is coupled.
    const std::size_t of_joint_6 =
        more.count("theta_6") + more.count("d_6") + more.count("a_6") + more.count("alpha_6");
    EXPECT_EQ(of_joint_6, 3u);
}

TEST(Calibration, AJointThatNeverTurnsIsNoticed) {
    Robot robot;
    for (auto& row : robot.table(measured, "poses").rows) row[first_q + 3] = 0.0;
    measure_exactly(robot, somewhere());
    const auto prepared = robot.prepare(measured);
    ASSERT_NE(prepared, nullptr) << robot.words();
    const auto held = held_in(*prepared);
    EXPECT_GT(held.size(), 7u) << "with joint 4 fixed, links 3 to 5 are one body";
    bool of_joint_4_or_5 = false;
    for (const auto& [name, reason] : held)
        of_joint_4_or_5 = of_joint_4_or_5 || ((name.ends_with("_4") || name.ends_with("_5")) &&
                                              reason.find("coupled") != std::string::npos);
    EXPECT_TRUE(of_joint_4_or_5);
}

TEST(Calibration, AParameterCanBeHeld) {
    Robot robot;
    SetupTable held;
    held.units = {Unit()};
    held.rows = {{std::string("alpha_4")}};
    robot.setup(simulated).values["held"] = held;
    EXPECT_FALSE(parameters(robot.run(simulated, 0)).contains("alpha_4"));
    std::get<SetupTable>(robot.setup(simulated).values["held"]).rows = {{std::string("alpha_9")}};
    EXPECT_EQ(robot.prepare(simulated), nullptr);
    EXPECT_TRUE(robot.says("no parameter 'alpha_9'")) << robot.words();
}

TEST(Calibration, MorePosesTellMore) {
    Robot robot;
    const auto fifty = parameters(robot.run(simulated, 0));
    robot.setup(simulated).values["pose_count"] = Quantity{200.0, Unit()};
    const auto many = parameters(robot.run(simulated, 0));
    for (const char* symbol : {"d_3", "a_3", "alpha_4", "theta_2"})
        EXPECT_NEAR(many.at(symbol).u / fifty.at(symbol).u, .5, .12) << symbol << ": u falls with the root";
}

// --- residuals and validation

TEST(Calibration, AnOutlierIsNamed) {
    Robot robot;
    auto& row = robot.table(measured, "poses").rows[16];
    row[x_column + 2] = std::get<double>(row[x_column + 2]) + .3;
    const auto prepared = robot.prepare(measured);
    ASSERT_NE(prepared, nullptr);
    EXPECT_TRUE(robot.says("pose P17: the residual of its")) << robot.words();
    EXPECT_TRUE(robot.says("times as large as the uncertainties of points and readings explain"));
    std::size_t outliers = 0;
    for (const auto& r : test::rows_of(table_called(*prepared, "residuals")))
        outliers += english_of(r.back()) == "outlier";
    EXPECT_GE(outliers, 1u);
    row[1] = std::string("check");
    ASSERT_NE(robot.prepare(measured), nullptr);
    EXPECT_TRUE(robot.problems.empty()) << "held back, it does no harm: " << robot.words();
}

TEST(Calibration, PosesHeldBackAgreeWithTheIdentifiedArm) {
    Robot robot;
    const UncertaintyResult r = robot.run(measured, 0);
    const Table table = table_called(*robot.prepare(measured), "check-poses");
    ASSERT_EQ(table.rows, 10u);
    std::size_t disagree = 0;
    for (const auto& row : test::rows_of(table)) {
        EXPECT_GT(test::si_of(row[1]), 20.0 * test::si_of(row[5])) << "nominal is far worse";
        disagree += test::si_of(row[7]) > 1.0;
    }
    EXPECT_LE(disagree, 4u) << "30 coordinates, 5 % of them beyond U";
    // The same uncertainty by the engine: points, fit and check pose together.
    double largest = 0.0;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == "check C1")
            largest = std::max(largest, 2.0 * y.first_order.standard_uncertainty);
    EXPECT_NEAR(largest / test::si_of(table.columns[6].cell(0)), 1.0, 1e-9);
}

TEST(Calibration, UncertainReadingsCount) {
    Robot robot;
    const auto before = parameters(robot.run(simulated, 0));
    for (auto& row : robot.asset_table("er10l-calibrated", "joints").rows)
        row[9] = .002;  // u_encoder, degrees
    const auto after = parameters(robot.run(simulated, 0));
    for (const char* symbol : {"d_3", "a_2", "alpha_4"})
        EXPECT_GT(after.at(symbol).u, 1.5 * before.at(symbol).u) << symbol;
}

TEST(Calibration, AnInstrumentOfTheProjectMeasures) {
    Robot robot;
    covaria::Setup setup;
    setup.values["kind"] = std::string("tracker");
    setup.values["distance_constant"] = Quantity{.01, Unit::of("mm")};
    setup.values["angle_azimuth"] = Quantity{3.0, Unit::of("arcsec")};
    setup.values["angle_elevation"] = Quantity{3.0, Unit::of("arcsec")};
    robot.project.assets.push_back({"tracker", "spherical-instrument", "Tracker", {}, setup});
    auto& values = robot.setup(simulated).values;
    values["point_uncertainty"] = std::string("asset");
    values["instrument"] = std::string("tracker");
    const auto prepared = robot.prepare(simulated);
    ASSERT_NE(prepared, nullptr) << robot.words();
    bool from_tracker = false;
    for (const UncertaintyComponent& c : prepared->inputs.components)
        from_tracker = from_tracker || c.id.starts_with("tracker.");
    EXPECT_TRUE(from_tracker);
    const auto found = parameters(robot.run(simulated, 0));
    EXPECT_GT(found.at("d_4").u, 0.0);
}

// --- refusals

TEST(Calibration, TooFewPosesAreRefused) {
    Robot robot;
    SetupTable& poses = robot.table(measured, "poses");
    poses.rows.resize(8);
    EXPECT_EQ(robot.prepare(measured), nullptr);
    EXPECT_TRUE(robot.says("give 24 coordinates, no more than there are unknowns")) << robot.words();
    poses.rows.resize(2);
    EXPECT_EQ(robot.prepare(measured), nullptr);
    EXPECT_TRUE(robot.says("the fit has 2 poses")) << robot.words();
}

TEST(Calibration, AnOrientationThatIsMissingIsNamed) {
    Robot robot;
    robot.setup(measured).values["quantity"] = std::string("poses");
    EXPECT_EQ(robot.prepare(measured), nullptr);
    EXPECT_TRUE(robot.says("pose P1: its orientation is missing")) << robot.words();
}

TEST(Calibration, ReadingsOfTheWrongSignDoNotPassForAnArm) {
    Robot robot;
    for (auto& row : robot.table(measured, "poses").rows) row[first_q] = -std::get<double>(row[first_q]);
    const auto prepared = robot.prepare(measured);
    EXPECT_TRUE(!prepared || robot.says("times as large as the uncertainties")) << robot.words();
}

TEST(Calibration, TheLayoutSaysHowManyPosesHaveAnUncertainty) {
    Robot robot;
    const auto prepared = robot.prepare(measured);
    ASSERT_TRUE(prepared);
    const Layout layout = prepared->model->layout({});
    const auto shown = std::ranges::count_if(
        layout.points, [](const LayoutPoint& point) { return point.inputs.has_value(); });
    EXPECT_EQ(shown, 6);
    EXPECT_EQ(layout.uncertain_points, 60u);
}

}  // namespace
}  // namespace covaria::robot_calibration_test
