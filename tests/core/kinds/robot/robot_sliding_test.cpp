// Robots with joints that slide: a gantry with a turning wrist, a SCARA; inverse kinematics, what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "core/kinds/robot/serial_robot.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_sliding_test {
namespace {

/// x, y, z of a gantry slide, then the tool turns about z; the tool is 100 mm off that axis.
const char* const gantry = R"({"id": "gantry", "kind": "serial-robot", "name": "Gantry", "setup": {
  "joints": {"columns": ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]", "type", "s_zero [mm]", "s_min [mm]",
                         "s_max [mm]", "u_s_encoder [mm]", "u_encoder [deg]"],
    "rows": [[90, 0, 0, 90, "sliding", 0, -500, 2500, 0.1, null],
             [90, 0, 0, 90, "sliding", 0, null, null, 0.2, null],
             [0, 0, 0, 0, "sliding", 50, 0, 800, 0.3, null],
             [0, 0, 100, 0, null, null, null, null, null, 0.05]]},
  "uncertainties": {"columns": ["source", "joint", "u_alpha [deg]"], "rows": [["squareness", 1, 0.01]]}}})";

std::string project_with(const std::string& poses, const std::string& targets = "") {
    return std::string(R"({"format": "covaria", "schemaVersion": 1, "title": "", "notes": "", "assets": [)") +
           gantry +
           R"(], "analyses": [{"id": "a", "model": "robot-pose", "name": "a", "setup": {"robot": "gantry")" +
           (poses.empty()
                ? ""
                : R"(, "poses": {"columns": ["name", "s_1 [mm]", "s_2 [mm]", "s_3 [mm]", "q_4 [deg]"],
           "rows": [)" +
                      poses + "]}") +
           (targets.empty()
                ? ""
                : R"(, "targets": {"columns": ["name", "x [mm]", "y [mm]", "z [mm]", "alpha [deg]",
           "beta [deg]", "gamma [deg]"], "rows": [)" +
                      targets + "]}") +
           "}}]}";
}

struct Made {
    explicit Made(const std::string& text) {
        LoadedProject loaded = parse_project(text, {}, "test");
        problems = loaded.problems;
        assets = made_assets(loaded.project, problems);
        if (!problems.has_errors()) analysis = made_analysis(loaded.project, "a", problems);
    }
    const SerialRobotSource& robot() const {
        return *offers<SerialRobotSource>(assets.find("gantry")->asset);
    }
    bool complains(const std::string& words) const {
        for (const Problem& p : problems.items())
            if ((p.path + " " + p.message.english()).find(words) != std::string::npos) return true;
        for (const Problem& p : problems.items())
            std::printf("%s %s\n", p.path.c_str(), p.message.english().c_str());
        return false;
    }

    Problems problems;
    AssetLibrary assets;
    std::shared_ptr<const PreparedAnalysis> analysis;
};

TEST(SlidingJoints, ReadingsMoveTheToolAlongTheirAxes) {
    const Made made(project_with(R"(["p", 300, -200, 450, 30])"));
    ASSERT_TRUE(made.analysis);
    const std::vector<double> zero{0, 0, .05, 0};
    const Eigen::Isometry3d start = link_frames(made.robot(), zero).back();
    const auto frames = link_frames(made.robot(), zero);
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> q = zero;
        q[i] += .25;
        const Eigen::Isometry3d moved = link_frames(made.robot(), q).back();
        EXPECT_LT((moved.translation() - start.translation() - .25 * frames[i].linear().col(2)).norm(),
                  1e-14);
        EXPECT_LT((moved.linear() - start.linear()).norm(), 1e-15);
    }
}

TEST(SlidingJoints, TheirUncertaintyIsThatOfTheToolAlongThem) {
    const Made made(project_with(R"(["p", 300, -200, 450, 30])"));
    ASSERT_TRUE(made.analysis);
    EXPECT_EQ(made.analysis->inputs.quantities[made.analysis->inputs.find("s_2,1")].unit.text(), "mm");
    const UncertaintyResult result = run_analysis(*made.analysis).value();
    const Eigen::Isometry3d X = link_frames(made.robot(), {.3, -.2, .45, std::acos(-1.0) / 6}).back();
    // the variance by hand: scales along their axes, the wrist by its lever, the squareness by its own
    const auto frames = link_frames(made.robot(), {.3, -.2, .45, std::acos(-1.0) / 6});
    const double deg = std::acos(-1.0) / 180;
    Eigen::Vector3d variance = Eigen::Vector3d::Zero();
    const double u[] = {1e-4, 2e-4, 3e-4};
    for (std::size_t i = 0; i < 3; ++i) variance += (u[i] * frames[i].linear().col(2)).cwiseAbs2();
    variance +=
        (.05 * deg * frames[3].linear().col(2).cross(X.translation() - frames[3].translation())).cwiseAbs2();
    variance +=
        (.01 * deg * frames[1].linear().col(0).cross(X.translation() - frames[1].translation())).cwiseAbs2();
    for (int k = 0; k < 3; ++k) {
        const OutputResult& out = result.outputs[static_cast<std::size_t>(k)];
        EXPECT_NEAR(out.first_order.estimate, X.translation()[k], 1e-12);
        EXPECT_NEAR(out.first_order.standard_uncertainty, std::sqrt(variance[k]), 1e-10) << k;
        const MonteCarloOutput& found = *out.monte_carlo;
        EXPECT_NEAR(found.standard_uncertainty, std::sqrt(variance[k]),
                    4 * found.standard_error_of_uncertainty + 1e-8);
    }
}

TEST(SlidingJoints, InverseKinematicsFindsTheirReadings) {
    const Made made(project_with(
        "", R"(["t", 700, 300, 250, null, null, null], ["far", 0, 0, 90000, null, null, null])"));
    EXPECT_TRUE(made.complains("pose far: no readings within the limits"));
    EXPECT_FALSE(made.complains("pose t:"));
    const std::vector<double> q{.4, -.3, .6, 1.2};
    const Made forward(project_with(""));
    const Eigen::Isometry3d X = link_frames(forward.robot(), q).back();
    char row[200];
    const Eigen::Vector3d p = 1e3 * X.translation();
    std::snprintf(row, sizeof row, R"(["t", %.17g, %.17g, %.17g, null, null, null])", p.x(), p.y(), p.z());
    const Made found(project_with("", row));
    ASSERT_TRUE(found.analysis) << (found.problems.empty() ? ""
                                                           : found.problems.items()[0].message.english());
    const auto tables = found.analysis->model->evaluation();
    std::vector<double> readings;
    for (std::size_t i = 1; i <= 4; ++i) readings.push_back(test::si_of(tables[0].columns[i].cell(0)));
    EXPECT_LT((link_frames(found.robot(), readings).back().translation() - X.translation()).norm(), 1e-7);
    EXPECT_EQ(tables[0].columns[1].key, "s_1");
    EXPECT_EQ(tables[0].columns[1].unit->text(), "mm");
}

TEST(SlidingJoints, LimitsAndWrongColumnsAreSaid) {
    EXPECT_TRUE(Made(project_with(R"(["p", 300, -200, 900, 0])")).complains("reading 900 mm of joint 3"));
    std::string text = project_with(R"(["p", 300, -200, 450, 30])");
    text.replace(text.find("\"s_2 [mm]\""), 10, "\"q_2 [deg]\"");
    EXPECT_TRUE(Made(text).complains("/poses/rows/0/q_2 joint 2 of Gantry slides: its reading is s_2"));
    text = project_with(R"(["p", 300, -200, 450, 30])");
    text.replace(text.find("\"u_encoder [deg]\""), 17, "\"u_repeatability [deg]\"");
    text.replace(text.find("0.3, null]"), 10, "0.3, 0.01]");
    EXPECT_TRUE(Made(text).complains("joint 3 slides: state its readings as lengths"));
}

/// An identification whose nominal robot is the gantry.
std::string identification(const std::string& model, const std::string& setup = "") {
    std::string text = project_with("");
    const std::string before = R"("setup": {"robot": "gantry"}})";
    text.replace(text.find("\"model\": \"robot-pose\""), 21, "\"model\": \"" + model + "\"");
    text.replace(text.find(before), before.size(), R"("setup": {"nominal": "gantry")" + setup + "}}");
    return text;
}

TEST(SlidingJoints, DrawNoCircles) {
    EXPECT_TRUE(Made(identification("robot-circle-points")).complains("slides and draws no circle"));
}

TEST(SlidingJoints, HaveARangeForSimulatedPosesByTheirLimits) {
    EXPECT_TRUE(Made(identification("robot-calibration"))
                    .complains("joint 2 slides: without its limits there is no range"));
}

// The arm that was built: an axis out of square, a tool that is longer, a scale that begins elsewhere.
TEST(SlidingJoints, AreIdentifiedFromMeasuredPoses) {
    std::string built = project_with("");
    built.replace(built.find("[90, 0, 0, 90, \"sliding\", 0, -500"), 33,
                  "[90, 0.8, 0, 90.3, \"sliding\", 0, -500");
    built.replace(built.find("[0, 0, 100, 0, null"), 19, "[0, 0, 101.5, 0, null");
    const Made arm(built);
    std::string rows;
    for (int k = 0; k < 24; ++k) {
        const double s[] = {2000 * std::fmod(.37 * k, 1.0), 800 * std::fmod(.59 * k, 1.0) - 300,
                            700 * std::fmod(.83 * k, 1.0) + 50, 300 * std::fmod(.71 * k, 1.0) - 150};
        const Eigen::Vector3d p = 1e3 * link_frames(arm.robot(), {1e-3 * s[0], 1e-3 * s[1], 1e-3 * s[2],
                                                                  s[3] * std::acos(-1.0) / 180})
                                            .back()
                                            .translation();
        char row[300];
        std::snprintf(row, sizeof row, R"(%s["P%d", "%s", %.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g])",
                      k == 0 ? "" : ", ", k, k < 20 ? "fit" : "check", s[3], p.x(), p.y(), p.z(), s[0], s[1],
                      s[2]);
        rows += row;
    }
    const Made made(identification("robot-calibration", R"(, "data": "measured", "poses": {"columns": ["name",
        "use", "q_4 [deg]", "x [mm]", "y [mm]", "z [mm]", "s_1 [mm]", "s_2 [mm]", "s_3 [mm]"], "rows": [)" +
                                                            rows + "]}"));
    ASSERT_TRUE(made.analysis) << (made.problems.empty() ? "" : made.problems.items()[0].message.english());
    const UncertaintyResult result = evaluate_first_order(*made.analysis->propagated, {}).value();
    std::size_t deviations = 0;
    for (const OutputResult& out : result.outputs) {
        if (out.quantity.name.english().find("calculated less measured") == std::string::npos) continue;
        ++deviations;
        EXPECT_NEAR(out.first_order.estimate, 0.0, 1e-9) << out.quantity.symbol;
        EXPECT_GT(out.first_order.standard_uncertainty, 1e-5);
    }
    EXPECT_EQ(deviations, 12u) << "three coordinates of four check poses";
    EXPECT_EQ(made.analysis->inputs.quantities[made.analysis->inputs.find("s_2,3")].unit.text(), "mm");
    EXPECT_TRUE(
        Made(identification("robot-calibration", R"(, "data": "measured", "poses": {"columns": ["name",
        "q_1 [deg]", "x [mm]", "y [mm]", "z [mm]"], "rows": [["P", 3, 0, 0, 0]]})"))
            .complains("joint 1 slides: its reading is s_1"));
}

}  // namespace
}  // namespace covaria::robot_sliding_test
