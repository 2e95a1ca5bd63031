// Arms of which one joint moves another along: joint 3 turns by what joints 2 and 3 read.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/kinds/robot/inverse_kinematics.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_coupled_test {
namespace {

constexpr double deg = std::numbers::pi / 180;

/// A six-axis arm; `coupling`: moved_by and share of joint 3.
std::string project_with(const std::string& coupling, const std::string& analysis) {
    return R"({"format": "covaria", "schemaVersion": 2, "title": "", "notes": "", "assets": [
  {"id": "arm", "kind": "serial-robot", "name": "Arm", "setup": {"joints": {
    "columns": ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]", "q_zero [deg]", "direction", "u_encoder [deg]",
                "moved_by", "share"],
    "rows": [[0, 450, 50, 90, 0, null, 0.01, null, null],
             [90, 0, 440, 0, 10, null, 0.02, null, null],
             [0, 0, 35, 90, -5, "negative", 0.03, )" +
           coupling + R"(],
             [0, 420, 0, -90, 0, null, 0.01, null, null],
             [0, 0, 0, 90, 0, null, 0.01, null, null],
             [0, 80, 0, 0, 0, null, 0.01, null, null]]}}}], "analyses": [)" +
           analysis + "]}";
}

constexpr const char* pose = R"({"id": "a", "model": "robot-pose", "name": "a", "setup": {"robot": "arm",
  "poses": {"columns": ["name", "q_1 [deg]", "q_2 [deg]", "q_3 [deg]", "q_4 [deg]", "q_5 [deg]", "q_6 [deg]"],
            "rows": [["p", 20, 35, -15, 40, 60, -10]]}}})";

struct Made {
    explicit Made(const std::string& coupling, const std::string& asked = pose) {
        LoadedProject loaded = parse_project(project_with(coupling, asked), {}, "test");
        problems = loaded.problems;
        assets = made_assets(loaded.project, problems);
        if (!problems.has_errors()) analysis = made_analysis(loaded.project, "a", problems);
    }
    const SerialRobotSource& robot() const { return *offers<SerialRobotSource>(assets.find("arm")->asset); }
    std::string words() const {
        std::string text;
        for (const Problem& p : problems.items()) text += p.path + " " + p.message.english() + "\n";
        return text;
    }
    Problems problems;
    AssetLibrary assets;
    std::shared_ptr<const PreparedAnalysis> analysis;
};

TEST(CoupledJoints, TurnByTheirOwnReadingAndTheShareOfTheOther) {
    const Made coupled("2, 0.7"), alone("null, null");
    const std::vector<double> q{.3, .6, -.2, .7, 1.1, -.4};
    std::vector<double> shifted = q;
    // joint 3 counts against its reading; joint 2 is at 10 degrees where it has not moved
    shifted[2] -= .7 * (q[1] - 10 * deg);
    const auto a = link_frames(coupled.robot(), q), b = link_frames(alone.robot(), shifted);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i].matrix() - b[i].matrix()).norm(), 1e-14) << i;
    EXPECT_GT((a[3].matrix() - link_frames(alone.robot(), q)[3].matrix()).norm(), 0.1);
    EXPECT_EQ(first_coupled_joint(coupled.robot()), 3u);
    EXPECT_EQ(first_coupled_joint(alone.robot()), 0u);
}

TEST(CoupledJoints, ShareTheUncertaintyOfTheOtherReading) {
    const Made made("2, null");
    ASSERT_TRUE(made.analysis) << made.words();
    const UncertaintyResult result = evaluate_first_order(*made.analysis->propagated, {}).value();
    const std::vector<double> q{20 * deg, 35 * deg, -15 * deg, 40 * deg, 60 * deg, -10 * deg};
    const double u[] = {.01 * deg, .02 * deg, .03 * deg, .01 * deg, .01 * deg, .01 * deg};
    Eigen::Vector3d variance = Eigen::Vector3d::Zero();
    const auto tool = [&](std::size_t j, double by) {
        std::vector<double> moved = q;
        moved[j] += by;
        return Eigen::Vector3d(link_frames(made.robot(), moved).back().translation());
    };
    constexpr double h = 1e-5;
    for (std::size_t j = 0; j < 6; ++j) {
        const Eigen::Vector3d slope =
            (8.0 * (tool(j, h) - tool(j, -h)) - (tool(j, 2 * h) - tool(j, -2 * h))) / (12 * h);
        variance += (u[j] * slope).cwiseAbs2();
    }
    for (int k = 0; k < 3; ++k) {
        const FirstOrderOutput& out = result.outputs[static_cast<std::size_t>(k)].first_order;
        EXPECT_NEAR(out.estimate, tool(0, 0.0)[k], 1e-12);
        EXPECT_NEAR(out.standard_uncertainty, std::sqrt(variance[k]), 1e-9 * std::sqrt(variance[k])) << k;
    }
}

TEST(CoupledJoints, AreReachedByInverseKinematics) {
    const Made made("2, 1");
    const std::vector<double> q{.3, .5, -.6, .7, 1.1, -.4};
    const Eigen::Isometry3d X = link_frames(made.robot(), q).back();
    const robot::InverseSolution found = robot::solve_inverse(
        made.robot(), {.position = X.translation(), .orientation = Eigen::Matrix3d(X.linear())},
        std::vector<double>(6, 0.0));
    ASSERT_EQ(found.q.size(), 6u);
    EXPECT_LT((link_frames(made.robot(), found.q).back().matrix() - X.matrix()).norm(), 1e-7);
}

TEST(CoupledJoints, AreIdentifiedFromPosesAndLeadNoPointRoundTheirAxis) {
    const Made simulated("2, 1", R"({"id": "a", "model": "robot-calibration", "name": "a", "setup":
      {"nominal": "arm", "data": "simulated", "pose_count": 40, "ball": {"position": [80, 60, 40], "angles": [0, 0, 0], "lengthUnit": "mm", "angleUnit": "deg"}}})");
    ASSERT_TRUE(simulated.analysis) << simulated.words();
    const auto asset = simulated.analysis->model->as_asset("a");
    ASSERT_TRUE(offers<SerialRobotSource>(asset.get()));
    EXPECT_EQ(first_coupled_joint(*offers<SerialRobotSource>(asset.get())), 3u)
        << "what was found is coupled";
    const UncertaintyResult result = evaluate_first_order(*simulated.analysis->propagated, {}).value();
    for (const OutputResult& out : result.outputs)
        EXPECT_TRUE(std::isfinite(out.first_order.standard_uncertainty)) << out.quantity.symbol;
    const Made circles("2, 1", R"({"id": "a", "model": "robot-circle-points", "name": "a", "setup":
      {"nominal": "arm"}})");
    EXPECT_NE(circles.words().find("joint 3 is moved along by another"), std::string::npos)
        << circles.words();
}

TEST(CoupledJoints, SayWhatTheyCannotBe) {
    for (const auto& [coupling, words] : {std::pair("3, 1", "joint 3 does not move itself along"),
                                          std::pair("7, 1", "the robot has no joint 7"),
                                          std::pair("null, 0.5", "say which joint moves joint 3 along")}) {
        const Made made(coupling);
        EXPECT_NE(made.words().find(words), std::string::npos) << coupling << ": " << made.words();
    }
}

}  // namespace
}  // namespace covaria::robot_coupled_test
