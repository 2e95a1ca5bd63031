// The cube in the corner: its faces as the camera sees them, and the one that is clicked.
#include "viz/scene/view_cube.h"

#include <gtest/gtest.h>

#include <set>

namespace covaria::view_cube_test {
namespace {

constexpr PictureSize size{1280, 800};
constexpr double edge = 40.0;
constexpr Pixel centre{1200, 60};
const SceneBounds box{{-1, -1, -1}, {1, 1, 1}};

Pixel middle(const CubeFace& face) {
    Pixel sum{0, 0};
    for (const Pixel& corner : face.corners) sum = {sum.x + corner.x / 4, sum.y + corner.y / 4};
    return sum;
}

TEST(ViewCube, AFaceSeenStraightOnIsASquareWithUprightLetters) {
    for (std::size_t i = 1; i < standard_view_count; ++i) {
        const auto view = static_cast<StandardView>(i);
        const auto faces = view_cube(view_of(box, view, size), centre, edge);
        ASSERT_EQ(faces.size(), 1U) << i;
        EXPECT_EQ(faces[0].view, view);
        EXPECT_NEAR(faces[0].towards_eye, 1.0, 1e-12);
        EXPECT_NEAR(faces[0].corners[0].x, centre.x - edge / 2, 1e-9) << i;
        EXPECT_NEAR(faces[0].corners[0].y, centre.y - edge / 2, 1e-9) << i;
        EXPECT_NEAR(faces[0].corners[2].x, centre.x + edge / 2, 1e-9) << i;
        EXPECT_NEAR(faces[0].corners[2].y, centre.y + edge / 2, 1e-9) << i;
    }
}

TEST(ViewCube, IsoShowsTopFrontAndRight) {
    const auto faces = view_cube(view_of(box, StandardView::iso, size), centre, edge);
    std::set<StandardView> seen;
    for (const CubeFace& face : faces) {
        seen.insert(face.view);
        EXPECT_EQ(face_at(faces, middle(face)), face.view);
    }
    // The direction (-0.62, 1, -0.52) looks from the front right, from above.
    EXPECT_EQ(seen, (std::set{StandardView::top, StandardView::front, StandardView::right}));
    EXPECT_EQ(face_at(faces, {centre.x - edge, centre.y - edge}), std::nullopt);
}

TEST(ViewCube, EveryFaceCanBeReachedByTurning) {
    std::set<StandardView> seen;
    Camera camera = view_of(box, StandardView::iso, size);
    for (int i = 0; i < 24; ++i) {
        camera = orbited(camera, size, size.width / 24.0, i == 12 ? -size.width / 4.0 : 0.0);
        for (const CubeFace& face : view_cube(camera, centre, edge)) seen.insert(face.view);
    }
    EXPECT_EQ(seen.size(), 6U);
}

}  // namespace
}  // namespace covaria::view_cube_test
