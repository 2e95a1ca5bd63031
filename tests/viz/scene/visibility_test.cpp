// Items hidden and shown alone, and views saved with them.
#include "viz/scene/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viz/stewart_scene.h"
#include "viz/scene/saved_camera.h"

namespace covaria::visibility_test {
namespace {

constexpr PictureSize size{1280, 800};

bool has(const Scene& scene, const char* id) {
    return find_item(scene, id) != nullptr;
}
bool has_label(const Scene& scene, const char* id) {
    return std::any_of(scene.labels.begin(), scene.labels.end(),
                       [&](const SceneLabel& label) { return label.item == id; });
}

TEST(Visibility, NothingHiddenIsTheSceneItself) {
    EXPECT_EQ(visible_part(test::stewart_with_tracker(), {}), test::stewart_with_tracker());
    EXPECT_EQ(visible_part(test::stewart_with_tracker(), {{"body:nowhere"}, {}}),
              test::stewart_with_tracker())
        << "what is not there is not missed";
    EXPECT_EQ(visible_part(test::stewart_with_tracker(), {{}, "body:nowhere"}), test::stewart_with_tracker());
}

TEST(Visibility, ABodyGoesWithItsAxesAndLines) {
    const Scene scene = visible_part(test::stewart_with_tracker(), {{"body:tracker"}, {}});
    for (const char* id : {"body:tracker", "axes:tracker", "link:sight"}) {
        EXPECT_TRUE(has(test::stewart_with_tracker(), id)) << id;
        EXPECT_FALSE(has(scene, id)) << id;
    }
    EXPECT_TRUE(has_label(test::stewart_with_tracker(), "body:tracker"));
    EXPECT_FALSE(has_label(scene, "body:tracker"));
    EXPECT_TRUE(has(scene, "body:base") && has(scene, "point:b1"));
    EXPECT_EQ(scene.axes, test::stewart_with_tracker().axes) << "the picture does not jump";
    EXPECT_EQ(scene.legend.size() + 1, test::stewart_with_tracker().legend.size())
        << "no line of sight is left";
}

TEST(Visibility, ALineOfSightGoesWithThePointThatIsSeen) {
    const Scene whole = test::stewart_with_tracker();
    const std::string seen = "point:" + test::stewart_setup(200).layout.points[0].name;
    ASSERT_TRUE(has(whole, seen.c_str()));
    EXPECT_FALSE(has(visible_part(whole, {{seen}, {}}), "link:sight"));
    EXPECT_TRUE(has(visible_part(whole, {{"point:p2"}, {}}), "link:sight"));
    EXPECT_TRUE(has(visible_part(whole, {{}, "body:tracker"}), "link:sight"));
}

/// One field says where an instrument stands: its place, its axes and its body are one thing.
TEST(Visibility, AnInstrumentIsHiddenByItsPlaceOrItsAxes) {
    Scene scene = test::stewart_with_tracker();
    for (SceneBody& body : scene.bodies)
        if (body.item.id == "body:tracker") body.item.source = {"/station", true};
    for (SceneFrame& frame : scene.frames)
        if (frame.item.id == "axes:tracker") frame.item.source = {"/station", true};
    ScenePoint place{.item = {.id = "point:tracker", .position = {2, 0, 1}}, .radius = 0.01};
    place.item.source = {"/station", true};
    place.item.body = "body:tracker";
    scene.points.push_back(place);
    for (const char* id : {"body:tracker", "axes:tracker", "point:tracker"})
        EXPECT_EQ(thing_of(scene, id), "body:tracker") << id;
    EXPECT_EQ(thing_of(scene, "point:b1"), "point:b1") << "it stands on a plate, and is none";
    EXPECT_EQ(thing_of(scene, "no such item"), "no such item");
    const Scene left = visible_part(scene, {{"body:tracker"}, {}});
    for (const char* id : {"body:tracker", "axes:tracker", "point:tracker"})
        EXPECT_FALSE(has(left, id)) << id;
}

TEST(Visibility, PointsOfAHiddenPlateStay) {
    const Scene scene =
        visible_part(test::stewart_with_tracker(), {{"body:moving platform", "point:p2"}, {}});
    EXPECT_FALSE(has(scene, "body:moving platform"));
    EXPECT_TRUE(has(scene, "point:p1") && has_label(scene, "point:p1"));
    EXPECT_FALSE(has(scene, "point:p2") || has_label(scene, "point:p2"));
    const auto of_p2 = [](const auto& each) { return each.item.id == "point:p2"; };
    EXPECT_TRUE(std::none_of(scene.ellipsoids.begin(), scene.ellipsoids.end(), of_p2));
    EXPECT_TRUE(std::none_of(scene.clouds.begin(), scene.clouds.end(), of_p2));
    EXPECT_EQ(scene.clouds.size() + 1, test::stewart_with_tracker().clouds.size());
}

TEST(Visibility, AloneIsAnItemWithWhatStandsOnIt) {
    const Scene scene = visible_part(test::stewart_with_tracker(), {{}, "body:moving platform"});
    ASSERT_EQ(scene.bodies.size(), 1U);
    EXPECT_EQ(scene.points.size(), 3U);
    EXPECT_EQ(scene.points.front().item.id, "point:p1");
    EXPECT_EQ(scene.ellipsoids.size(), 3U);
    EXPECT_TRUE(scene.links.empty());
    const SceneBounds all = bounds_of(test::stewart_with_tracker()), alone = bounds_of(scene);
    EXPECT_LT((alone.high - alone.low).norm(), (all.high - all.low).norm()) << "fit shows it larger";
    EXPECT_EQ(visible_part(test::stewart_with_tracker(), {{}, "point:b1"}).points.size(), 1U);
}

TEST(SavedCamera, ComesBackInAPictureOfAnyForm) {
    Camera camera = view_of(bounds_of(test::stewart_with_tracker()), StandardView::iso, size);
    camera.perspective = true;
    const Visibility visibility{{"body:base", "link:sight"}, "body:tracker"};
    const SavedView view = saved_view("door", camera, size, visibility);
    EXPECT_EQ(visibility_of(view), visibility);
    const Camera back = camera_of(view, size);
    EXPECT_TRUE(back.direction.isApprox(camera.direction) && back.up.isApprox(camera.up));
    EXPECT_EQ(back.focal_point, camera.focal_point);
    EXPECT_DOUBLE_EQ(back.half_height, camera.half_height);
    EXPECT_TRUE(back.perspective);
    const PictureSize upright{400, 800};
    EXPECT_NEAR(camera_of(view, upright).half_height * upright.width / upright.height,
                camera.half_height * size.width / size.height, 1e-12)
        << "as wide as it was saved";
}

}  // namespace
}  // namespace covaria::visibility_test
