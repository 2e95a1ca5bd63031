// The studies of projects/er10l-c10.covaria: the workspace map and the sweeps that stand for Tables 3 and 4.
#include <gtest/gtest.h>

#include <cmath>

#include "core/made/load_project.h"
#include "core/study/study.h"
#include "tests/core/kinds/robot/robot_project.h"

namespace covaria::robot_study_test {
namespace {

using robot_test::Robot;

StudyResult run(Robot& robot, const char* analysis, const char* study) {
    Problems problems;
    const auto prepared = prepare_study(MadeProject::make(robot.project), analysis, study, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message.english();
    return run_study(*prepared).value();
}

TEST(RobotStudies, TheWorkspaceMap) {
    Robot robot;
    const StudyResult map = run(robot, "zero-pose", "workspace");
    ASSERT_EQ(map.points.size(), 125u);
    ASSERT_EQ(map.triples.size(), 1u);
    double least = 1e9, most = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < 125; ++i) {
        const double u = 1e3 * map.points[i].places[0].standard_uncertainty();
        least = std::min(least, u);
        most = std::max(most, u);
        sum += u / 125.0;
        EXPECT_NEAR(u, 1e3 * map.points[i % 25].places[0].standard_uncertainty(), 1e-9) << "depends on q1";
        EXPECT_NEAR(map.points[i].values[2].standard_uncertainty,
                    map.points[i % 25].values[2].standard_uncertainty, 1e-12);
    }
    EXPECT_NEAR(least, 1.5547, 1e-4);
    EXPECT_NEAR(most, 1.6330, 1e-4);
    EXPECT_NEAR(sum, 1.5863, 1e-4);
}

// A grid over places instead of readings: the robot goes there by inverse kinematics.
TEST(RobotStudies, AMapOverPlaces) {
    Robot robot;
    AnalysisEntry& analysis = robot.find("zero-pose");
    SetupTable targets;
    targets.units = {Unit(),          Unit::of("mm"),  Unit::of("mm"), Unit::of("mm"),
                     Unit::of("deg"), Unit::of("deg"), Unit::of("deg")};
    targets.rows = {{std::string("there"), 1200.0, 0.0, 900.0, 180.0, 0.0, 180.0}};
    analysis.setup.values["targets"] = targets;
    Study& study = analysis.studies.front();
    study.axes = {
        {.target = "/setup/targets/rows/0/x", .from = 900, .to = 1300, .unit = Unit::of("mm"), .values = 3},
        {.target = "/setup/targets/rows/0/y", .from = -300, .to = 300, .unit = Unit::of("mm"), .values = 3}};
    study.outputs = {{"there", "x"}, {"there", "y"}, {"there", "z"}};
    const StudyResult map = run(robot, "zero-pose", "workspace");
    for (std::size_t i = 0; i < 9; ++i) {
        ASSERT_TRUE(map.points[i].has_values()) << map.reasons[map.points[i].reason];
        const Eigen::Vector3d p = map.points[i].places[0].p_W;
        EXPECT_NEAR(p.x(), .9 + .2 * static_cast<double>(i / 3), 1e-6);
        EXPECT_NEAR(p.y(), -.3 + .3 * static_cast<double>(i % 3), 1e-6);
    }
}

TEST(RobotStudies, RangeAndNumberOfPoints) {
    Robot robot;
    const StudyResult range = run(robot, "trajectories-simulated", "range");
    ASSERT_EQ(range.axes[0].values, (std::vector<double>{10, 20, 30, 40, 50, 60}));
    const auto u_d3 = [](const StudyResult& r, std::size_t i) {
        return 1e3 * r.points[i].values[1].standard_uncertainty;
    };
    ASSERT_EQ(range.outputs[1].symbol, "d_3");
    EXPECT_NEAR(u_d3(range, 0), 3.33, .16 * 3.33);
    EXPECT_NEAR(u_d3(range, 5), .101, .16 * .101);
    EXPECT_NEAR(u_d3(range, 0) / u_d3(range, 5), 33.0, 3.5) << "falls with the square of the range";
    const StudyResult count = run(robot, "trajectories-simulated", "points");
    EXPECT_NEAR(u_d3(count, 0), .200, .16 * .2);
    EXPECT_NEAR(u_d3(count, 9), .077, .16 * .077);
}

}  // namespace
}  // namespace covaria::robot_study_test
