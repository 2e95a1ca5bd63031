// Identification from distances, planes and reflectors on projects/robot-readings.covaria: recovery,
// covariance, what the readings cannot tell, what is refused or warned of. The covariance is held against an
// independent solution in resources/verification/arm-readings.covaria.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/kinds/robot/serial_robot.h"
#include "tests/core/kinds/robot/shipped_project.h"

namespace covaria::robot_from_readings_test {
namespace {

using namespace robot_test;

struct Readings : ShippedProject {
    Readings() : ShippedProject("robot-readings.covaria") {}
};

// Columns of the tables.
constexpr std::size_t what = 2, other = 3, distance = 4, u_of_distance = 5, zero = 6, use = 7;
constexpr std::size_t x_of_place = 2, place = 8, u_of_place = 9, q_1 = 1, tau_1 = 15;
// Of the robot's table of uncertainties.
constexpr std::size_t u_d = 3, u_a = 4;

class EveryKind : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(FromReadings, EveryKind, testing::Values("distances", "planes", "reflectors"),
                         [](const auto& kind) { return std::string(kind.param); });

TEST_P(EveryKind, LeadsToTheCalibratedArm) {
    Readings readings;
    const auto found = parameters(readings.run(GetParam(), 0));
    EXPECT_TRUE(readings.problems.empty()) << readings.words();
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

TEST_P(EveryKind, MonteCarloAgreesWithItsCovariance) {
    Readings readings;
    const UncertaintyResult r = readings.run(GetParam(), 20'000);
    EXPECT_EQ(r.failed_trials, 0u);
    for (const OutputResult& y : r.outputs)
        EXPECT_NEAR(y.monte_carlo->standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                    4.0 * std::sqrt(.5 / 20'000))
            << y.quantity.group << y.quantity.symbol;
}

TEST(FromReadings, WhatTheReadingsCannotTellIsNamedWithItsPartners) {
    Readings readings;
    std::set<std::string> names;
    const auto held = held_in(*readings.prepare("reflectors"));
    for (const auto& [name, reason] : held) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"theta_1", "d_1", "d_2", "theta_6", "d_6", "a_6", "alpha_6"}));
    EXPECT_NE(held.at("theta_1").find("base rotation about z"), std::string::npos) << held.at("theta_1");
    EXPECT_NE(held.at("d_6").find("T1 z"), std::string::npos) << held.at("d_6");
    const auto by_points = held_in(*readings.prepare("distances"));
    EXPECT_FALSE(by_points.contains("theta_1")) << "base and points are known";
}

void take_out_distances_between_poses(Readings& readings) {
    std::erase_if(readings.table("planes", "distances").rows,
                  [](const auto& row) { return std::get<std::string>(row[what]) == "pose"; });
}

/// u of all lengths of the nominal robot, mm; empty: it states none.
void state_lengths(Readings& readings, SetupCell u) {
    for (auto& row :
         std::get<SetupTable>(readings.project.assets.front().setup.values.at("uncertainties")).rows)
        for (const std::size_t column : {u_d, u_a})
            if (!std::holds_alternative<std::monostate>(row[column])) row[column] = u;
}

TEST(FromReadings, TouchedPlanesDoNotTellTheScale) {
    Readings readings;
    const auto with_bar = parameters(readings.run("planes", 0));
    take_out_distances_between_poses(readings);
    state_lengths(readings, std::monostate{});
    const auto alone = parameters(readings.run("planes", 0));
    EXPECT_TRUE(readings.says("readings do not tell the scale")) << readings.words();
    EXPECT_TRUE(readings.says("d_4 is held at its nominal value")) << "the longest length";
    EXPECT_FALSE(alone.contains("d_4"));
    for (const char* angle : {"theta_2", "alpha_3", "alpha_5"}) {
        const double u = std::hypot(alone.at(angle).u, with_bar.at(angle).u);
        EXPECT_NEAR(alone.at(angle).value, with_bar.at(angle).value, 4.0 * u) << "angles have no scale";
    }
    EXPECT_NEAR(alone.at("a_2").value / 1060.0, with_bar.at("a_2").value / with_bar.at("d_4").value, 1e-5)
        << "the nominal d_4 is 1060 mm";
}

TEST(FromReadings, ANominalLengthGivesTheScaleAsUncertainAsItIs) {
    Readings readings;
    take_out_distances_between_poses(readings);
    state_lengths(readings, .5);
    const UncertaintyResult result = readings.run("planes", 0);
    const auto found = parameters(result);
    EXPECT_TRUE(readings.says("d_4 takes part with its nominal value")) << readings.words();
    EXPECT_NEAR(found.at("d_4").u, .5, .01);
    EXPECT_NEAR(found.at("a_2").u, .5 * 780.0 / 1060.0, .01);
    EXPECT_NEAR(found.at("a_2").value, calibrated.at("a_2"), 4.0 * found.at("a_2").u);
    EXPECT_LT(found.at("alpha_5").u, .002) << "angles have no scale";
}

TEST(FromReadings, ExactTouchesDoNotTellTheScaleEither) {
    Readings readings;
    take_out_distances_between_poses(readings);
    state_lengths(readings, std::monostate{});
    readings.setup("planes").values["u_distance"] = Quantity{0.0, Unit::of("mm")};
    for (auto& row : readings.table("planes", "distances").rows) row[u_of_distance] = 0.0;
    ASSERT_NE(readings.prepare("planes"), nullptr) << readings.words();
    EXPECT_TRUE(readings.says("do not tell the scale")) << readings.words();
}

// A better gauge does not make results less certain, wherever the scale is told from.
TEST(FromReadings, UFallsWithThatOfTheReadings) {
    Readings readings;
    take_out_distances_between_poses(readings);
    auto& rows = readings.table("planes", "distances").rows;
    double before = 0.0;
    for (const double u : {.001, .003, .01, .03, .1}) {
        for (auto& row : rows) row[u_of_distance] = u;
        const auto found = parameters(readings.run("planes", 0));
        EXPECT_GT(found.at("a_2").u, .99 * before) << u;
        before = found.at("a_2").u;
    }
}

TEST(FromReadings, AnExactReadingLeavesTheOthersTheirWeights) {
    Readings readings;
    const auto before = parameters(readings.run("distances", 0));
    readings.table("distances", "distances").rows[7][u_of_distance] = 0.0;
    const auto after = parameters(readings.run("distances", 0));
    for (const auto& [symbol, parameter] : before)
        EXPECT_LT(after.at(symbol).u, 1.05 * parameter.u) << symbol;
}

TEST(FromReadings, NoTrialOfCoarseReadingsIsLost) {
    Readings readings;
    for (auto& row : readings.table("distances", "distances").rows) row[u_of_distance] = 1.0;
    const UncertaintyResult r = readings.run("distances", 10'000);
    EXPECT_EQ(r.failed_trials, 0u);
}

TEST(FromReadings, AZeroOfOneReadingIsNoOutlier) {
    Readings readings;
    readings.table("distances", "distances").rows[5][zero] = std::string("alone");
    ASSERT_NE(readings.prepare("distances"), nullptr);
    EXPECT_TRUE(readings.problems.empty()) << readings.words();
}

TEST(FromReadings, AnUncertainPointHidesNoWrongReading) {
    Readings readings;
    for (auto& row : readings.table("distances", "places").rows) row[u_of_place] = .5;
    auto& row = readings.table("distances", "distances").rows[16];
    row[distance] = std::get<double>(row[distance]) + .3;
    ASSERT_NE(readings.prepare("distances"), nullptr);
    EXPECT_TRUE(readings.says("P5 from A: the residual is")) << readings.words();
}

TEST(FromReadings, APointThatNobodyMeasuredIsFoundWithoutApproximateCoordinates) {
    Readings readings;
    const auto known = parameters(readings.run("distances", 0));
    auto& places = readings.table("distances", "places");
    for (const std::size_t row : {0u, 2u}) {
        for (std::size_t k = 0; k < 3; ++k) places.rows[row][x_of_place + k] = std::monostate{};
        places.rows[row][place] = std::string("found");
    }
    const UncertaintyResult result = readings.run("distances", 0);
    const auto found = parameters(result);
    EXPECT_TRUE(readings.problems.empty()) << readings.words();
    for (const auto& [symbol, parameter] : known)
        EXPECT_NEAR(found.at(symbol).value, parameter.value, 4.0 * found.at(symbol).u) << symbol;
    std::map<std::string, double> A;
    for (const OutputResult& y : result.outputs)
        if (y.quantity.group == "A") A[y.quantity.symbol] = 1e3 * y.first_order.estimate;
    EXPECT_NEAR(A.at("x"), 1500.0, .1);
    EXPECT_NEAR(A.at("y"), 800.0, .1);
    EXPECT_NEAR(A.at("z"), 300.0, .1);
}

TEST(FromReadings, AKnownPointIsAsUncertainAsStated) {
    Readings readings;
    auto& places = readings.table("distances", "places").rows;
    const auto exact = parameters(readings.run("distances", 0));
    places[1][u_of_place] = 1e-6;
    const auto nearly = parameters(readings.run("distances", 0));
    places[1][u_of_place] = 0.1;
    const auto uncertain = parameters(readings.run("distances", 0));
    for (const auto& [symbol, parameter] : exact) {
        EXPECT_NEAR(nearly.at(symbol).u, parameter.u, 1e-6 * parameter.u) << symbol;
        EXPECT_GE(uncertain.at(symbol).u, parameter.u) << symbol;
    }
    EXPECT_GT(uncertain.at("theta_1").u, 2.0 * exact.at("theta_1").u);
}

TEST(FromReadings, TheScaleOfAllDistancesIsThatOfAllLengths) {
    Readings readings;
    const auto before = parameters(readings.run("planes", 0));
    readings.setup("planes").values["u_scale"] = Quantity{10.0, Unit::of("ppm")};
    const auto after = parameters(readings.run("planes", 0));
    for (const char* length : {"a_2", "d_4"}) {
        const double share = std::sqrt(std::pow(after.at(length).u, 2) - std::pow(before.at(length).u, 2));
        EXPECT_NEAR(share / (1e-5 * after.at(length).value), 1.0, .01) << length;
    }
    EXPECT_NEAR(after.at("alpha_3").u, before.at("alpha_3").u, .01 * before.at("alpha_3").u);
}

TEST(FromReadings, AWrongReadingIsNamed) {
    Readings readings;
    auto& row = readings.table("distances", "distances").rows[16];
    row[distance] = std::get<double>(row[distance]) + .3;
    ASSERT_NE(readings.prepare("distances"), nullptr);
    EXPECT_TRUE(readings.says("P5 from A: the residual is")) << readings.words();
    row[use] = std::string("check");
    ASSERT_NE(readings.prepare("distances"), nullptr);
    EXPECT_TRUE(readings.problems.empty()) << "held back, it does no harm: " << readings.words();
}

TEST(FromReadings, ReadingsHeldBackAgreeWithTheIdentifiedArm) {
    Readings readings;
    const UncertaintyResult r = readings.run("distances", 0);
    const auto rows = test::rows_of(table_called(*readings.prepare("distances"), "check-readings"));
    ASSERT_EQ(rows.size(), 16u);
    std::size_t beyond = 0, i = 0;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.group == "check") {
            EXPECT_NEAR(test::si_of(rows[i][2]), y.first_order.estimate, 1e-12);
            EXPECT_NEAR(test::si_of(rows[i][3]) / (2.0 * y.first_order.standard_uncertainty), 1.0, 1e-9);
            beyond += test::si_of(rows[i][4]) > 1.0;
            ++i;
        }
    EXPECT_EQ(i, 16u);
    EXPECT_LE(beyond, 3u);
}

/// A joint that stands c tau further than it reads, in every other pose.
TEST(FromReadings, ACompliantJointIsTold) {
    Readings readings;
    const auto stiff = parameters(readings.run("distances", 0));
    constexpr double torque = 400.0, compliance = 2.5;  // N m, urad/(N m)
    readings.setup("distances").values["compliance"] = std::string("found");
    EXPECT_FALSE(parameters(readings.run("distances", 0)).contains("c_2")) << "no pose has a torque";
    EXPECT_EQ(held_in(*readings.prepare("distances")).at("c_2"), "changes no reading");
    auto& poses = readings.table("distances", "poses").rows;
    for (std::size_t k = 0; k < poses.size(); k += 2) {
        poses[k][q_1 + 1] =
            std::get<double>(poses[k][q_1 + 1]) - 1e-6 * compliance * torque * 180.0 / std::numbers::pi;
        poses[k][tau_1 + 1] = torque;
    }
    const auto found = parameters(readings.run("distances", 0));
    EXPECT_TRUE(readings.problems.empty()) << readings.words();
    ASSERT_TRUE(found.contains("c_2"));
    EXPECT_FALSE(found.contains("c_3")) << "has no torque in any pose";
    EXPECT_NEAR(found.at("c_2").value, compliance, 4.0 * found.at("c_2").u);
    EXPECT_LT(found.at("c_2").u, .1);
    for (const auto& [symbol, parameter] : stiff)
        EXPECT_NEAR(found.at(symbol).value, parameter.value, 2.0 * parameter.u) << symbol;
}

TEST(FromReadings, WhatDoesNotFitTogetherIsRefused) {
    const auto refuses = [](const std::string& analysis, auto change, const std::string& words) {
        Readings readings;
        change(readings);
        EXPECT_EQ(readings.prepare(analysis), nullptr) << words;
        EXPECT_TRUE(readings.says(words)) << readings.words();
    };
    refuses(
        "distances", [](Readings& r) { r.table("distances", "distances").rows[3][0] = std::string("P99"); },
        "there is no pose 'P99'");
    refuses(
        "distances", [](Readings& r) { r.table("distances", "distances").rows[3][other] = std::string("Z"); },
        "there is no point 'Z'");
    refuses(
        "planes", [](Readings& r) { r.table("planes", "distances").rows[3][what] = std::string("point"); },
        "'E' is a plane and no point");
    refuses(
        "distances",
        [](Readings& r) { r.table("distances", "distances").rows[3][distance] = std::monostate{}; },
        "this distance was not measured");
    refuses(
        "distances", [](Readings& r) { r.table("distances", "distances").rows[3][distance] = -5.0; },
        "a distance from a point or pose is above zero");
    refuses(
        "distances",
        [](Readings& r) { r.table("distances", "places").rows[0][x_of_place] = std::monostate{}; },
        "A is known, but where it is is not said");
    refuses(
        "distances",
        [](Readings& r) {
            auto& rows = r.table("distances", "distances").rows;
            std::erase_if(rows, [](const auto& row) { return std::get<std::string>(row[other]) == "D"; });
            rows.resize(6);
        },
        "no more than there are unknowns");
}

}  // namespace
}  // namespace covaria::robot_from_readings_test
