// What can be grasped, and where a drag moves or turns it.
#include "viz/scene/handles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace covaria::handles_test {
namespace {

constexpr PictureSize size{1280, 800};
const auto everything = [](Layer) { return true; };

/// A station with axes whose pose can be written, a target in a table, and a point that nobody can move.
Scene a_scene() {
    Scene scene;
    scene.size = 2.0;
    SceneFrame axes;
    axes.item.id = "axes:tracker";
    axes.item.source = {"/station", true};
    axes.length = 0.4;
    scene.frames.push_back(axes);
    ScenePoint target{.item = {.id = "point:A", .name = "A", .position = {0.8, 0.3, 0}}, .radius = 0.01};
    target.item.source = {"/targets/rows/0", true};
    scene.points.push_back(target);
    scene.points.push_back({.item = {.id = "point:P", .position = {-0.8, 0.3, 0}}, .radius = 0.01});
    return scene;
}

std::optional<Handle> grasped(const Eigen::Vector3d& p, StandardView view = StandardView::top,
                              const std::string& selected = {}) {
    const Scene scene = a_scene();
    const Camera camera = view_of({{-1, -1, -1}, {1, 1, 1}}, view, size);
    return handle_at(scene, camera, size, project(camera, size, p), everything, selected, 14.0);
}

TEST(Handles, ItemsMoveAndTipsOfAxesTurn) {
    const auto target = grasped({0.8, 0.3, 0});
    ASSERT_TRUE(target);
    EXPECT_FALSE(target->turns());
    EXPECT_EQ(target->item.id, "point:A");
    const auto station = grasped({0, 0, 0});
    ASSERT_TRUE(station);
    EXPECT_FALSE(station->turns());
    EXPECT_EQ(station->item.name, "tracker") << "for the list of undo";
    const auto tip = grasped({0, 0.4, 0});
    ASSERT_TRUE(tip);
    EXPECT_TRUE(tip->turns());
    EXPECT_EQ(tip->tip, 1);
    EXPECT_FALSE(grasped({-0.8, 0.3, 0})) << "its position is written nowhere";
    EXPECT_FALSE(grasped({0.5, -0.5, 0}));
    EXPECT_FALSE(grasped({0, 0, 0.4}, StandardView::top)->turns()) << "the axis points at the eye";
}

TEST(Handles, TheTipFollowsThePointer) {
    const Camera camera = view_of({{-1, -1, -1}, {1, 1, 1}}, StandardView::iso, size);
    const auto handle = grasped({0.4, 0, 0}, StandardView::iso);
    ASSERT_TRUE(handle && handle->turns());
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const Eigen::Vector3d from(0.4, 0, 0);
    const Eigen::Matrix3d turn = turn_by(*handle, camera, size, project(camera, size, from),
                                         project(camera, size, expected * from), 0.0);
    EXPECT_TRUE(turn.isApprox(expected, 1e-9)) << "about y, which points most from the eye";
    const Eigen::Matrix3d steps = turn_by(*handle, camera, size, project(camera, size, from),
                                          project(camera, size, expected * from), std::numbers::pi / 36);
    EXPECT_NEAR(Eigen::AngleAxisd(steps).angle(), 30 * std::numbers::pi / 180, 1e-9) << "28.6 degrees";
}

TEST(Handles, SnappedCoordinatesAreWholeStepsInTheirFrame) {
    SceneItem item{.id = "point:A", .position = {0.8, 0.3, 0.1234}};
    item.source.X_WS.translation() = Eigen::Vector3d(0.05, 0, 0);
    const Eigen::Vector3d p = snapped(item, {0.97, 0.31, 0.1234}, 0.1);
    EXPECT_TRUE(p.isApprox(Eigen::Vector3d(0.95, 0.3, 0.1234), 1e-12)) << p.transpose();
}

}  // namespace
}  // namespace covaria::handles_test
