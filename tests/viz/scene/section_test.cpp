// A section of the scene: which side is cut away, where it begins, what remains to be marked and picked.
#include "viz/scene/section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viz/stewart_scene.h"
#include "viz/scene/dump_scene.h"
#include "viz/scene/handles.h"
#include "viz/scene/pick.h"
#include "viz/scene/trial_pick.h"

namespace covaria::section_test {
namespace {

constexpr PictureSize size{1280, 800};
const auto everything = [](Layer) { return true; };

Scene cut(Scene scene, const SectionPlane& section) {
    scene.section = section;
    return scene;
}

const auto bodies = [](Layer layer) { return layer == Layer::bodies; };

std::string picked(const Scene& scene, const Camera& camera, const Eigen::Vector3d& at,
                   const std::function<bool(Layer)>& shown = everything) {
    return pick_item(scene, camera, size, project(camera, size, at), shown).value_or("");
}

bool has_label(const Scene& scene, const std::string& id) {
    return std::ranges::any_of(scene.labels, [&](const SceneLabel& label) { return label.item == id; });
}

TEST(Section, EitherSideOfAPlaneIsCutAway) {
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d before = Eigen::Vector3d::Constant(7), beyond = before;
        before[axis] = 0.2;
        beyond[axis] = 0.3;
        EXPECT_TRUE((SectionPlane{axis, 0.25, true}.hides(beyond)));
        EXPECT_FALSE((SectionPlane{axis, 0.25, true}.hides(before)));
        EXPECT_TRUE((SectionPlane{axis, 0.25, false}.hides(before)));
        EXPECT_FALSE((SectionPlane{axis, 0.25, false}.hides(beyond)));
        EXPECT_DOUBLE_EQ((SectionPlane{axis, 0.25, true}.depth_of(beyond)), 0.3 - 0.25);
    }
    EXPECT_FALSE(is_cut_away(test::stewart_with_tracker(), {100, 100, 100})) << "there is no section";
}

TEST(Section, BeginsInTheMiddleWithTheSideOfTheEyeCutAway) {
    const Scene scene = test::stewart_with_tracker();
    const SceneBounds bounds = bounds_of_items(scene);
    for (const StandardView view :
         {StandardView::iso, StandardView::top, StandardView::front, StandardView::left})
        for (int axis = 0; axis < 3; ++axis) {
            const Camera camera = view_of(bounds_of(scene), view, size);
            const SectionPlane section = middle_section(scene, axis, camera);
            EXPECT_DOUBLE_EQ(section.at, (bounds.low[axis] + bounds.high[axis]) / 2);
            if (std::abs(camera.direction[axis]) < 0.1) continue;
            EXPECT_TRUE(section.hides(-100 * camera.direction)) << "the eye is far on that side";
        }
    Scene near = scene;
    near.focus = SceneBounds{{1.5, 0, 0}, {2.5, 1, 1}};
    EXPECT_DOUBLE_EQ(middle_section(near, 0, {}).at, 2.0) << "what the scene is about";
}

TEST(Section, StepsAreRoundNumbersOverTheWhole) {
    const Scene scene = test::stewart_with_tracker();
    const SceneBounds bounds = bounds_of_items(scene);
    for (int axis = 0; axis < 3; ++axis) {
        const SectionSteps steps = steps_of_section(scene, axis);
        EXPECT_LE(steps.at(0), bounds.low[axis] + 1e-12);
        EXPECT_GE(steps.at(steps.count), bounds.high[axis] - 1e-12);
        EXPECT_GE(steps.count, 500);
        EXPECT_LT(steps.count, 1500);
        const double in_steps = steps.at(37) / steps.step;
        EXPECT_NEAR(in_steps, std::round(in_steps), 1e-9);
        EXPECT_EQ(steps.nearest(steps.at(123)), 123);
        EXPECT_EQ(steps.nearest(1e6), steps.count);
        EXPECT_EQ(steps.nearest(-1e6), 0);
    }
    EXPECT_EQ(steps_of_section({}, 0).count, 0) << "there is nothing to cut";
}

TEST(Section, WordsAndMarksOfWhatIsCutAwayAreGone) {
    const Scene whole = test::stewart_with_tracker();
    EXPECT_EQ(left_by_section(whole), whole);
    const double middle = find_item(whole, "point:p1")->position.z() / 2;
    const Scene scene = left_by_section(cut(whole, {2, middle, true}));  // the upper plate goes
    for (const ScenePoint& point : whole.points) {
        const bool stays = point.item.position.z() < middle;
        EXPECT_EQ(find_item(scene, point.item.id) != nullptr, stays) << point.item.id;
        EXPECT_EQ(has_label(scene, point.item.id), stays && has_label(whole, point.item.id)) << point.item.id;
    }
    EXPECT_EQ(find_item(scene, "body:moving platform"), nullptr);
    EXPECT_NE(find_item(scene, "body:base"), nullptr);
    EXPECT_LT(scene.labels.size(), whole.labels.size());
    for (const SceneCloud& cloud : scene.clouds) {
        ASSERT_EQ(cloud.size(), cloud.trials.size());
        for (std::size_t i = 0; i < cloud.size(); ++i) EXPECT_LE(cloud.dot(i).z(), middle);
    }
    const auto sight =
        std::ranges::find_if(scene.links, [](const SceneLink& link) { return link.item.id == "link:sight"; });
    ASSERT_NE(sight, scene.links.end());
    EXPECT_DOUBLE_EQ(sight->from.z(), middle) << "a line of sight ends at the plane";
    EXPECT_EQ(sight->to, whole.points[0].item.position);
}

TEST(Section, WhatIsCutAwayIsNotPicked) {
    const Scene whole = test::stewart_with_tracker();
    const Camera top = view_of(bounds_of(whole), StandardView::top, size);
    const Eigen::Vector3d p = find_item(whole, "point:p2")->position, on_base(0.25, 0.15, 0);
    const double middle = p.z() / 2;
    EXPECT_EQ(picked(whole, top, p), "point:p2");
    EXPECT_NE(picked(cut(whole, {2, middle, true}), top, p), "point:p2");
    EXPECT_EQ(picked(cut(whole, {2, middle, false}), top, p), "point:p2");
    EXPECT_EQ(picked(cut(whole, {2, middle, true}), top, on_base, bodies), "body:base");
    EXPECT_EQ(picked(cut(whole, {2, middle, false}), top, on_base, bodies), "");
    EXPECT_EQ(picked(cut(whole, {0, 0.0, true}), top, on_base, bodies), "")
        << "that half of the plate is gone";
    EXPECT_EQ(picked(cut(whole, {0, 0.0, false}), top, on_base, bodies), "body:base");
}

TEST(Section, AnEllipsoidThatIsOpenedIsPickedByItsInside) {
    Scene scene;
    SceneEllipsoid ball;
    ball.item.id = "point:a";
    ball.axes = 0.5 * Eigen::Matrix3d::Identity();
    scene.ellipsoids = {ball};
    scene.size = 1.0;
    const Camera top = view_of({{-1, -1, -1}, {1, 1, 1}}, StandardView::top, size);
    for (const double at : {0.4, 0.0, -0.4})
        EXPECT_EQ(picked(cut(scene, {2, at, true}), top, {0, 0, 0}), "point:a");
    EXPECT_EQ(picked(cut(scene, {2, -0.6, true}), top, {0, 0, 0}), "");
    EXPECT_EQ(picked(cut(scene, {2, -0.4, true}), top, {0.4, 0, 0}), "")
        << "it does not reach there any more";
}

TEST(Section, NeitherTrialsNorAxesOfWhatIsCutAwayAreGrasped) {
    const Scene whole = test::stewart_with_tracker();
    const Camera top = view_of(bounds_of(whole), StandardView::top, size);
    const SceneCloud& cloud = whole.clouds.front();
    const Eigen::Vector3d dot = cloud.dot(3);
    const Pixel at = project(top, size, dot);
    EXPECT_TRUE(trial_at(whole, top, size, at, everything, 2.0));
    EXPECT_FALSE(trial_at(cut(whole, {0, dot.x() - 10.0, true}), top, size, at, everything, 2.0));
}

TEST(Section, IsToldByTheDump) {
    const Scene scene = cut(test::stewart_with_tracker(), {1, 0.25, false});
    EXPECT_NE(dump_scene(scene).find("section across y at 250 hides low\n"), std::string::npos);
    EXPECT_EQ(dump_scene(test::stewart_with_tracker()).find("section"), std::string::npos);
}

}  // namespace
}  // namespace covaria::section_test
