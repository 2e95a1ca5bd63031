// Camera: projection and its inverse, views, orbit, pan, zoom; picking; placement of labels.
#include "viz/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/viz/stewart_scene.h"
#include "viz/scene/clear_corner.h"
#include "viz/scene/label_placement.h"
#include "viz/scene/pick.h"

namespace covaria::camera_test {
namespace {

constexpr PictureSize size{1280, 800};

Scene stewart() {
    const auto setup = test::stewart_setup(200);
    return build_scene(setup.source(), {});
}
Camera iso() {
    return view_of(bounds_of(stewart()), StandardView::iso, size);
}
const auto everything = [](Layer) { return true; };

TEST(Camera, WorldAtIsTheInverseOfProject) {
    const Eigen::Vector3d p(0.2, -0.3, 0.9);
    const Camera camera = iso();
    const Eigen::Vector3d back = world_at(camera, size, project(camera, size, p), p);
    EXPECT_LT((back - p).norm(), 1e-12);
}

TEST(Camera, StandardViewsShowTheirAxes) {
    const SceneBounds bounds = bounds_of(stewart());
    struct Expected {
        StandardView view;
        Eigen::Vector3d right, up;
    };
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                          z = Eigen::Vector3d::UnitZ();
    for (const Expected& e : {Expected{StandardView::top, x, y}, Expected{StandardView::front, x, z},
                              Expected{StandardView::right, y, z}, Expected{StandardView::bottom, x, -y},
                              Expected{StandardView::back, -x, z}, Expected{StandardView::left, -y, z}}) {
        const Camera camera = view_of(bounds, e.view, size);
        EXPECT_TRUE(camera.right().isApprox(e.right));
        EXPECT_TRUE(camera.up.isApprox(e.up));
    }
    EXPECT_EQ(standard_view_from("top"), StandardView::top);
    EXPECT_EQ(standard_view_from("behind"), std::nullopt);
}

/// Random boxes, pictures and corners: nothing of the box is under the corner, and all of it in the picture.
TEST(Camera, KeepsTheSceneClearOfACorner) {
    constexpr double room = 50.0;
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int moved = 0, left = 0;
    for (int i = 0; i < 200; ++i) {
        const PictureSize picture{static_cast<int>(between(500, 1600)), static_cast<int>(between(300, 900))};
        const SceneBounds box{Eigen::Vector3d::Zero(), {between(0.1, 3), between(0.1, 3), between(0.1, 3)}};
        const ScreenRect corner{10, 10, between(100, 0.3 * picture.width), between(20, 150)};
        for (const bool perspective : {false, true}) {
            const Camera fit = view_of(box, StandardView::iso, picture, room, perspective);
            const Camera clear = clear_of_corner(fit, box, picture, corner, room);
            if (clear == fit) {
                ++left;
                continue;
            }
            ++moved;
            for (int k = 0; k < 12; ++k) {
                // Along the edges.
                for (double t = 0.0; t <= 1.0; t += 0.02) {
                    Eigen::Vector3d p = box.low;
                    const int axis = k % 3;
                    p[axis] += t * (box.high - box.low)[axis];
                    if (k / 3 & 1) p[(axis + 1) % 3] = box.high[(axis + 1) % 3];
                    if (k / 3 & 2) p[(axis + 2) % 3] = box.high[(axis + 2) % 3];
                    const Pixel at = project(clear, picture, p);
                    EXPECT_FALSE(at.x < corner.x + corner.width && at.y < corner.y + corner.height);
                    EXPECT_TRUE(at.x > 0 && at.x < picture.width && at.y < picture.height);
                }
            }
        }
    }
    EXPECT_GT(moved, 20);
    EXPECT_GT(left, 20) << "where nothing was covered";
}

/// A long network of instruments, in a pane of a window with the legend of its results.
TEST(Camera, ALongScenePassesBelowALongLegend) {
    const SceneBounds box{{-0.7, -1.7, -1.4}, {10.7, 1.7, 1.3}};
    const ScreenRect legend{9, 40, 230, 95};
    for (const PictureSize picture : {PictureSize{700, 420}, PictureSize{620, 380}}) {
        const Camera fit = view_of(box, StandardView::iso, picture, 50.0);
        EXPECT_NE(clear_of_corner(fit, box, picture, legend, 50.0), fit) << picture.width;
    }
}

TEST(Camera, PerspectiveShowsNearThingsLarger) {
    Camera camera = iso();
    camera.perspective = true;
    const Eigen::Vector3d p(0.2, -0.3, 0.9);
    EXPECT_LT((world_at(camera, size, project(camera, size, p), p) - p).norm(), 1e-12);
    const Eigen::Vector3d step = 0.1 * camera.right(), towards_eye = -0.4 * camera.direction;
    const auto length_at = [&](const Eigen::Vector3d& at) {
        return project(camera, size, at + step).x - project(camera, size, at).x;
    };
    EXPECT_NEAR(length_at(camera.focal_point) * metres_per_pixel(camera, size), 0.1, 1e-12);
    EXPECT_GT(length_at(camera.focal_point + towards_eye), 1.05 * length_at(camera.focal_point));
    EXPECT_LT(length_at(camera.focal_point - towards_eye), length_at(camera.focal_point) / 1.05);
    const Pixel pixel{300, 200};
    const Ray ray = ray_through(camera, size, pixel);
    for (const double along : {-0.3, 0.5}) {
        const Pixel at = project(camera, size, ray.origin + along * ray.direction);
        EXPECT_NEAR(at.x, pixel.x, 1e-9);
        EXPECT_NEAR(at.y, pixel.y, 1e-9);
    }
}

TEST(Camera, SmallPicturesKeepRoomForWords) {
    constexpr double room = 50.0;
    const SceneBounds b = bounds_of(stewart());
    for (PictureSize s : {PictureSize{660, 320}, PictureSize{320, 660}, PictureSize{2560, 1600}}) {
        const Camera camera = view_of(b, StandardView::iso, s, room);
        for (int i = 0; i < 8; ++i) {
            const Eigen::Vector3d corner(i & 1 ? b.high.x() : b.low.x(), i & 2 ? b.high.y() : b.low.y(),
                                         i & 4 ? b.high.z() : b.low.z());
            const Pixel at = project(camera, s, corner);
            EXPECT_GE(std::min(at.x, s.width - at.x), room - 1e-6) << s.width << " x " << s.height;
            EXPECT_GE(std::min(at.y, s.height - at.y), room - 1e-6) << s.width << " x " << s.height;
        }
    }
}

TEST(Camera, AFootBelowThePictureMovesNothingInIt) {
    const SceneBounds b = bounds_of(stewart());
    const Camera camera = view_of(b, StandardView::iso, {660, 320}, 50.0);
    for (const Eigen::Vector3d& corner : {b.low, b.high}) {
        const Pixel before = project(camera, {660, 320}, corner);
        const Pixel after = project(with_foot(camera, {660, 320}, 30), {660, 350}, corner);
        EXPECT_NEAR(after.x, before.x, 1e-9);
        EXPECT_NEAR(after.y, before.y, 1e-9);
    }
}

TEST(Camera, EverythingIsInThePicture) {
    const SceneBounds b = bounds_of(stewart());
    for (StandardView view : {StandardView::iso, StandardView::top, StandardView::front, StandardView::right})
        for (PictureSize s : {PictureSize{1280, 800}, PictureSize{400, 300}, PictureSize{300, 900}}) {
            for (int i = 0; i < 16; ++i) {
                const Camera camera = view_of(b, view, s, 0.0, i >= 8);
                const Eigen::Vector3d corner(i & 1 ? b.high.x() : b.low.x(), i & 2 ? b.high.y() : b.low.y(),
                                             i & 4 ? b.high.z() : b.low.z());
                const Pixel at = project(camera, s, corner);
                EXPECT_TRUE(at.x > 0 && at.x < s.width && at.y > 0 && at.y < s.height);
            }
        }
}

TEST(Camera, OrbitKeepsTheFrameOrthogonalAndZUpright) {
    Camera camera = iso();
    for (int i = 0; i < 200; ++i) camera = orbited(camera, size, 13.0, i < 100 ? 17.0 : -29.0);
    EXPECT_NEAR(camera.direction.norm(), 1.0, 1e-12);
    EXPECT_NEAR(camera.direction.dot(camera.up), 0.0, 1e-12);
    EXPECT_NEAR(camera.right().z(), 0.0, 1e-9) << "the horizon stays level";
    EXPECT_GE(camera.up.z(), -1e-9);
    EXPECT_TRUE(orbited(iso(), size, size.width, 0).direction.isApprox(iso().direction, 1e-9))
        << "a full turn";
}

TEST(Camera, DragToTheRightTurnsTheNearSideToTheRight) {
    const Camera before = iso();
    const Eigen::Vector3d near = before.focal_point - 0.3 * before.direction;
    const Pixel a = project(before, size, near), b = project(orbited(before, size, 20, 0), size, near);
    EXPECT_GT(b.x, a.x);
    const Pixel c = project(orbited(before, size, 0, 20), size, near);
    EXPECT_GT(c.y, a.y);
}

TEST(Camera, PanMovesWithThePointerAndZoomScales) {
    const Camera camera = iso();
    const Eigen::Vector3d p(0.1, 0.2, 0.3);
    const Pixel a = project(camera, size, p), b = project(panned(camera, size, 30, -12), size, p);
    EXPECT_NEAR(b.x - a.x, 30, 1e-9);
    EXPECT_NEAR(b.y - a.y, -12, 1e-9);
    EXPECT_NEAR(zoomed(camera, 2).half_height, camera.half_height / 2, 1e-15);
    EXPECT_EQ(zoomed(camera, 0).half_height, camera.half_height);
    for (const bool perspective : {false, true}) {
        Camera about = camera;
        about.perspective = perspective;
        const Pixel pointer{100, 333};
        const Eigen::Vector3d under = world_at(about, size, pointer, about.focal_point);
        const Pixel after = project(zoomed(about, 1.7, size, pointer), size, under);
        EXPECT_NEAR(after.x, pointer.x, 1e-9) << "what is under the pointer stays there";
        EXPECT_NEAR(after.y, pointer.y, 1e-9);
    }
}

TEST(Pick, FindsEachPointUnderItsPixel) {
    const Scene scene = stewart();
    const Camera camera = iso();
    for (const char* id : {"point:b1", "point:b2", "point:b3", "point:p1", "point:p2", "point:p3"}) {
        const Pixel at = project(camera, size, find_item(scene, id)->position);
        EXPECT_EQ(pick_item(scene, camera, size, at, everything).value_or(""), id);
    }
    EXPECT_EQ(pick_item(scene, camera, size, {3, 3}, everything), std::nullopt);
}

/// Points that stand close in a small picture: A was taken for B, for it is nearer to the eye.
TEST(Pick, OfPointsWithinReachTheOneThatThePointerIsOn) {
    const Scene scene = stewart();
    const Camera far = zoomed(iso(), 0.1);
    for (const char* id : {"point:b1", "point:b2", "point:b3", "point:p1", "point:p2", "point:p3"}) {
        const Pixel at = project(far, size, find_item(scene, id)->position);
        EXPECT_EQ(pick_item(scene, far, size, at, everything, 40.0).value_or(""), id);
    }
}

TEST(Pick, PlatesEllipsoidsAndHiddenLayers) {
    const Scene scene = stewart();
    const Camera top = view_of(bounds_of(scene), StandardView::top, size);
    const Pixel on_base = project(top, size, {0.25, 0.15, 0});
    EXPECT_EQ(pick_item(scene, top, size, on_base, everything).value_or(""), "body:base");
    const Pixel on_ellipsoid = project(top, size, {0.196 + 0.045, -0.111, 0});
    EXPECT_EQ(pick_item(scene, top, size, on_ellipsoid, everything).value_or(""), "point:p2");
    const auto no_ellipsoids = [](Layer layer) { return layer != Layer::ellipsoids; };
    EXPECT_EQ(pick_item(scene, top, size, on_ellipsoid, no_ellipsoids).value_or(""), "body:moving platform");
}

TEST(LabelPlacement, NoTwoLabelsOverlap) {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 30; ++i)
        requests.push_back({{200.0 + 7 * (i % 6), 150.0 + 9 * (i / 6)}, 40, 14, 5, i % 3});
    const auto placed = place_labels(requests, {0, 0, 400, 300}, {{0, 0, 400, 40}});
    int count = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (!placed[i]) continue;
        ++count;
        EXPECT_GE(placed[i]->y, 40) << "below what is taken";
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(placed[j] && placed[i]->overlaps(*placed[j])) << i << " and " << j;
    }
    EXPECT_GE(count, 8);
}

TEST(LabelPlacement, HigherPriorityGoesFirst) {
    const std::vector<LabelRequest> requests{{{50, 50}, 90, 90, 0, 1}, {{50, 50}, 90, 90, 0, 2}};
    const auto placed = place_labels(requests, {0, 0, 150, 150}, {});
    EXPECT_TRUE(placed[1].has_value());
    EXPECT_FALSE(placed[0].has_value());
}

TEST(LabelPlacement, CoversWhatIsDrawnOnlyWithoutOtherRoom) {
    const std::vector<LabelRequest> requests{{{75, 75}, 40, 14, 4, 1}};
    const ScreenLine right{{110, 0}, {110, 150}, 40}, thin{{80, 0}, {80, 150}}, all{{75, 0}, {75, 150}, 75};
    for (const ScreenLine& line : {right, thin}) {
        const auto beside = place_labels(requests, {0, 0, 150, 150}, {}, {line});
        ASSERT_TRUE(beside[0]);
        EXPECT_FALSE(line.crosses(*beside[0]));
        EXPECT_EQ(place_labels(requests, {0, 0, 150, 150}, {}, {all, line}), beside) << "covers least";
    }
    EXPECT_TRUE(place_labels(requests, {0, 0, 150, 150}, {}, {all})[0]);
    const std::vector<ScreenLine> bundle(20, all);
    EXPECT_FALSE(place_labels(requests, {0, 0, 150, 150}, {}, bundle)[0]) << "no label on a bundle of lines";
    std::vector<LabelRequest> selected = requests;
    selected[0].is_needed = true;
    EXPECT_TRUE(place_labels(selected, {0, 0, 150, 150}, {}, bundle)[0]);
}

TEST(LabelPlacement, LabelsOnOneLineDoNotTouch) {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 12; ++i) requests.push_back({{60.0 + 30 * i, 150}, 40, 14, 4, 0, 5});
    const auto placed = place_labels(requests, {0, 0, 500, 300}, {});
    for (std::size_t i = 0; i < placed.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(placed[i] && placed[j] && placed[i]->grown(4.9, 0).overlaps(*placed[j]))
                << i << " and " << j;
}

TEST(LabelPlacement, NoLeaderRunsThroughALabelOfMoreWeight) {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 20; ++i)
        requests.push_back({{200.0 + 8 * (i % 5), 150.0 + 6 * (i / 5)}, 40, 14, 4, 20 - i, 5});
    const auto placed = place_labels(requests, {0, 0, 400, 300}, {});
    int leaders = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const auto leader = placed[i] ? leader_of(requests[i], *placed[i]) : std::nullopt;
        leaders += leader.has_value();
        for (std::size_t j = 0; leader && j < i; ++j)
            EXPECT_FALSE(placed[j] && leader->crosses(*placed[j])) << i << " and " << j;
    }
    EXPECT_GE(leaders, 3);
}

}  // namespace
}  // namespace covaria::camera_test
