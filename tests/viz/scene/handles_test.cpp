// The handles of items, and where a drag moves or turns them.
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

TEST(Handles, AnArrowMovesAlongItsAxisOnly) {
    const Scene scene = a_scene();
    const Camera camera = view_of({{-1, -1, -1}, {1, 1, 1}}, StandardView::iso, size);
    const HandleMarks marks = handle_marks(scene, camera, size, "point:A", 58.0);
    ASSERT_EQ(marks.arrows.size(), 3U);
    EXPECT_TRUE(marks.tips.empty()) << "a point does not turn";
    const auto& along_y = marks.arrows[1];
    const Pixel middle{0.5 * (along_y.from.x + along_y.to.x), 0.5 * (along_y.from.y + along_y.to.y)};
    const auto arrow = arrow_at(scene, camera, size, middle, "point:A", 58.0, 6.0);
    ASSERT_TRUE(arrow);
    EXPECT_EQ(arrow->axis, 1);
    const Eigen::Vector3d p(0.8, 0.3, 0), step(0, 0.25, 0);
    const Eigen::Vector3d there =
        moved_along(*arrow, camera, size, project(camera, size, p), project(camera, size, p + step));
    EXPECT_TRUE(there.isApprox(p + step, 1e-9)) << there.transpose();
    // A way of the pointer across the axis does not count.
    const Pixel off = project(camera, size, p + step);
    const Eigen::Vector3d beside =
        moved_along(*arrow, camera, size, project(camera, size, p), {off.x + 30, off.y});
    EXPECT_EQ(beside.x(), 0.8);
    EXPECT_EQ(beside.z(), 0.0);
    EXPECT_FALSE(arrow_at(scene, camera, size, {middle.x, middle.y + 90}, "point:A", 58.0, 6.0));
}

TEST(Handles, WhatCannotBeWrittenHasNoneAndAPoseHasTips) {
    const Scene scene = a_scene();
    const Camera top = view_of({{-1, -1, -1}, {1, 1, 1}}, StandardView::top, size);
    EXPECT_TRUE(handle_marks(scene, top, size, "point:P", 58.0).arrows.empty());
    EXPECT_TRUE(handle_marks(scene, top, size, "no such item", 58.0).arrows.empty());
    const HandleMarks marks = handle_marks(scene, top, size, "axes:tracker", 58.0);
    EXPECT_EQ(marks.arrows.size(), 2U) << "z points at the eye";
    EXPECT_EQ(marks.tips.size(), 3U);
}

}  // namespace
}  // namespace covaria::handles_test
