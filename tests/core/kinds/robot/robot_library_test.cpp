// The arms of the library stand where their makers' documents say, at readings of zero.
#include <gtest/gtest.h>

#include "core/kinds/robot/serial_robot.h"
#include "core/made/library.h"
#include "tests/core/made.h"

namespace covaria::robot_library_test {
namespace {

TEST(RobotLibrary, FlangesStandWhereTheirMakersSay) {
    struct {
        const char* id;
        Eigen::Vector3d p_mm;
        double z_of_flange;  ///< z-component of the flange's z-axis
    } const expected[] = {{"ur3e", {-456.75, -223.15, 66.5}, 0},   {"ur5e", {-817.2, -232.9, 62.8}, 0},
                          {"ur10e", {-1184.25, -290.7, 60.85}, 0}, {"ur20", {-1590.7, -355.3, 77.0}, 0},
                          {"abb-irb-120", {374, 0, 630}, 0},       {"abb-irb-1600", {815, 0, 1186.5}, 0},
                          {"franka-panda", {88, 0, 926}, -1},      {"kuka-lbr-iiwa-7", {0, 0, 1266}, 1},
                          {"kuka-lbr-iiwa-14", {0, 0, 1306}, 1},   {"puma-560", {452.1, -150.05, 431.8}, 1},
                          {"er10l-c10", {1355, 0, 1424}, 0}};
    Project project;
    for (const LibraryItem& item : load_library().items) project.assets.push_back(item.asset);
    Problems problems;
    const AssetLibrary assets = made_assets(project, problems);
    for (const auto& e : expected) {
        const AssetLibrary::Entry* entry = assets.find(e.id);
        ASSERT_NE(entry, nullptr) << e.id;
        ASSERT_NE(offers<SerialRobotSource>(entry->asset), nullptr) << e.id;
        const SerialRobotSource& robot = *offers<SerialRobotSource>(entry->asset);
        std::vector<double> q(robot.joints().size(), 0.0);
        if (robot.joints()[1].zero < -1.5) q[1] = robot.joints()[1].zero;  // ER10L: the paper's zero pose
        const Eigen::Isometry3d X = link_frames(robot, q).back();
        EXPECT_LT((1e3 * X.translation() - e.p_mm).norm(), 1e-6) << e.id << X.translation().transpose();
        EXPECT_NEAR(X.linear()(2, 2), e.z_of_flange, 1e-9) << e.id;
    }
}

}  // namespace
}  // namespace covaria::robot_library_test
