// A picture is framed anew where something has left it, and not because what it shows is edited.
#include "viz/scene/framing.h"

#include <gtest/gtest.h>

namespace covaria::framing_test {
namespace {

constexpr PictureSize size{800, 600};

struct Looked {
    Framing framing;
    Camera camera = view_of({{-1, -1, -1}, {1, 1, 1}}, StandardView::front, size);

    static std::shared_ptr<Scene> scene(double x, std::size_t lines) {
        auto made = std::make_shared<Scene>();
        made->title = "pose";
        made->points = {{.item = {.id = "point:a"}},
                        {.item = {.id = "point:b", .position = {x, 0, 0}}, .radius = 0.01}};
        made->legend.resize(lines);
        return made;
    }
    bool fits(double x, std::size_t lines, bool framed, bool held = false) {
        return framing.next(scene(x, lines), framed, held)(camera, size);
    }
};

TEST(Framing, TheFirstResultFramesAndALaterOneDoesNot) {
    Looked looked;
    EXPECT_TRUE(looked.fits(0.5, 0, true));
    EXPECT_TRUE(looked.fits(0.5, 3, true)) << "the legend has come";
    looked.camera = orbited(looked.camera, size, 60, 20);
    EXPECT_FALSE(looked.fits(0.6, 1, true, true)) << "dragged: the result is out of date";
    EXPECT_FALSE(looked.fits(0.6, 1, true));
    EXPECT_FALSE(looked.fits(0.6, 3, true)) << "evaluated again";
}

TEST(Framing, WhatLeavesTheFramedPictureIsFetchedBack) {
    Looked looked;
    looked.fits(0.5, 0, true);
    EXPECT_FALSE(looked.fits(9.0, 0, true, true)) << "not under the hand";
    EXPECT_TRUE(looked.fits(9.0, 0, true)) << "it was seen before the drag";
    looked.camera.half_height = 0.1;
    looked.fits(0.5, 0, true);
    EXPECT_FALSE(looked.fits(0.4, 0, true)) << "the camera has left it";
}

TEST(Framing, WhatSomebodyLooksAtCloselyStays) {
    Looked looked;
    looked.fits(0.5, 3, true);
    EXPECT_FALSE(looked.fits(9.0, 4, false)) << "a is still there";
    looked.camera.focal_point = {9.0, 0, 0};
    EXPECT_TRUE(looked.fits(0.0, 4, false)) << "nothing is to be seen";
    EXPECT_FALSE(looked.fits(0.5, 4, false)) << "nor was there before";
}

}  // namespace
}  // namespace covaria::framing_test
