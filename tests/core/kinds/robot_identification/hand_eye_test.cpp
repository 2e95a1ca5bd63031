// A X = Z B on projects/eye-on-hand.covaria, whose readings are simulated: against a second solution in numpy
// (Gauss and Newton with central differences), and what the poses cannot tell.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/math/rotation.h"
#include "tests/core/kinds/robot/shipped_project.h"

namespace covaria::hand_eye_test {
namespace {

struct HandEye : robot_test::ShippedProject {
    HandEye() : ShippedProject("eye-on-hand.covaria") {}

    std::vector<std::vector<SetupCell>>& poses(const std::string& id) { return table(id, "poses").rows; }
};

struct Figures {
    double estimate, u;
};

void expect_figures(const UncertaintyResult& result, const std::vector<Figures>& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const OutputResult& y = result.outputs[i];
        const double u = y.quantity.unit.interval_from_si(y.first_order.standard_uncertainty);
        EXPECT_NEAR(y.quantity.unit.from_si(y.first_order.estimate), expected[i].estimate, 1e-6 * u)
            << y.quantity.group << y.quantity.symbol;
        EXPECT_NEAR(u, expected[i].u, 1e-6 * u) << y.quantity.group << y.quantity.symbol;
    }
}

TEST(HandEye, ACameraOnTheHandIsThatOfASecondSolution) {
    HandEye hand_eye;
    const UncertaintyResult result = hand_eye.run("camera", 0);
    EXPECT_TRUE(hand_eye.problems.empty()) << hand_eye.words();
    expect_figures(result, {{45.250244798, .0482678055},
                            {-31.710038539, .0402965339},
                            {88.415817018, .0494303827},
                            {1.495980365, .00661307806},
                            {-.794270798, .00530648921},
                            {90.994473372, .00622275992},
                            {812.005599121, .0222487867},
                            {95.003525293, .0222563655},
                            {11.975191003, .0489823946},
                            {.403833868, .00743425172},
                            {-.302225780, .00762509343},
                            {33.015777903, .00885375669}});
}

TEST(HandEye, ATrackerBesideTheRobotIsThatOfASecondSolution) {
    HandEye hand_eye;
    const UncertaintyResult result = hand_eye.run("tracker", 0);
    expect_figures(result, {{80.695000730, .0092243135},
                            {59.199494870, .00946897674},
                            {41.091374164, .00939492018},
                            {2599.917625124, .0303094227},
                            {-1450.114836073, .0374889394},
                            {320.024945204, .0549179903},
                            {.200830252, .00109758794},
                            {-.099817181, .00130706934},
                            {146.996861340, .00110799086}});
    EXPECT_EQ(result.outputs.size(), 9u) << "a reflector has no orientation";
}

TEST(HandEye, MonteCarloAgreesWithItsCovariance) {
    HandEye hand_eye;
    for (const char* id : {"camera", "tracker"}) {
        const UncertaintyResult result = hand_eye.run(id, 20'000);
        EXPECT_EQ(result.failed_trials, 0u);
        for (const OutputResult& y : result.outputs)
            EXPECT_NEAR(y.monte_carlo->standard_uncertainty / y.first_order.standard_uncertainty, 1.0,
                        4.0 * std::sqrt(.5 / 20'000))
                << y.quantity.group << y.quantity.symbol;
    }
}

// What the camera measures of the board is what a board on the hand shows to a camera that stands still,
// inverted.
TEST(HandEye, WhatTheFlangeCarriesCanBeExchanged) {
    HandEye hand_eye;
    hand_eye.setup("camera").values["u_angle"] = Quantity{0.0, Unit::of("deg")};
    hand_eye.setup("camera").values["u_position"] = Quantity{0.0, Unit::of("mm")};
    const UncertaintyResult on_the_hand = hand_eye.run("camera", 0);
    for (auto& row : hand_eye.poses("camera")) {
        Eigen::Isometry3d B = Eigen::Isometry3d::Identity();
        Eigen::Vector3d angles;
        for (int k = 0; k < 3; ++k) {
            B.translation()[k] = std::get<double>(row[static_cast<std::size_t>(8 + k)]);
            angles[k] = std::get<double>(row[static_cast<std::size_t>(11 + k)]) * std::numbers::pi / 180.0;
        }
        B.linear() = rotation_from_zyx<double>(angles);
        const Eigen::Isometry3d back = B.inverse();
        angles = zyx_from_rotation<double>(back.linear());
        for (int k = 0; k < 3; ++k) {
            row[static_cast<std::size_t>(8 + k)] = back.translation()[k];
            row[static_cast<std::size_t>(11 + k)] = angles[k] * 180.0 / std::numbers::pi;
        }
    }
    hand_eye.setup("camera").values["mount"] = std::string("target");
    const UncertaintyResult beside = hand_eye.run("camera", 0);
    for (std::size_t i = 0; i < 12; ++i)  // other residuals are made small: close, not the same
        EXPECT_NEAR(beside.outputs[i].estimate, on_the_hand.outputs[i].estimate, i % 6 < 3 ? 1e-4 : 5e-4)
            << on_the_hand.outputs[i].quantity.group << on_the_hand.outputs[i].quantity.symbol;
}

TEST(HandEye, TurnsAboutOneDirectionLeaveThePositionAlongItUntold) {
    HandEye hand_eye;
    auto& poses = hand_eye.poses("tracker");
    for (auto& row : poses) row[5] = row[6] = 0.0;  // alpha, beta
    ASSERT_NE(hand_eye.prepare("tracker"), nullptr) << hand_eye.words();
    for (const Table& table : hand_eye.prepare("tracker")->model->evaluation())
        if (table.id == "not-identified") {
            std::string names;
            for (const auto& row : test::rows_of(table))
                names += english_of(row[0]) + ": " + english_of(row[1]) + "; ";
            EXPECT_NE(names.find("instrument z: moves the measured points as"), std::string::npos) << names;
        }
}

TEST(HandEye, AWrongPoseIsNamedAndDoesNoHarmHeldBack) {
    HandEye hand_eye;
    auto& row = hand_eye.poses("camera")[6];
    row[8] = std::get<double>(row[8]) + 2.0;
    ASSERT_NE(hand_eye.prepare("camera"), nullptr);
    EXPECT_TRUE(hand_eye.says("pose P7: a residual is")) << hand_eye.words();
    row[1] = std::string("check");
    ASSERT_NE(hand_eye.prepare("camera"), nullptr);
    EXPECT_TRUE(hand_eye.problems.empty()) << hand_eye.words();
}

TEST(HandEye, WhatIsMissingIsSaid) {
    HandEye hand_eye;
    hand_eye.poses("camera")[2][12] = std::monostate{};
    EXPECT_EQ(hand_eye.prepare("camera"), nullptr);
    EXPECT_TRUE(hand_eye.says("pose P3: its measured orientation is missing")) << hand_eye.words();
    hand_eye = {};
    hand_eye.poses("tracker").resize(4);
    EXPECT_EQ(hand_eye.prepare("tracker"), nullptr);
    EXPECT_TRUE(hand_eye.says("it needs 5 or more")) << hand_eye.words();
}

}  // namespace
}  // namespace covaria::hand_eye_test
