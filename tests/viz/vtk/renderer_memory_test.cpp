// A window that is open for a day shows thousands of scenes: each gives back what it took.
#include <gtest/gtest.h>
#include <malloc.h>

#include "tests/viz/stewart_scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::renderer_memory_test {
namespace {

double mebibytes_in_use() {
    return static_cast<double>(mallinfo2().uordblks) / (1024.0 * 1024.0);
}

TEST(RendererMemory, ScenesThatFollowEachOtherDoNotAddUp) {
    SceneRenderer renderer;
    renderer.set_size(320, 200);
    const auto setup = test::stewart_setup(500);
    const Scene first = build_scene(setup.source(), {});
    const auto show = [&](int from, int to) {
        for (int i = from; i < to; ++i) {
            Scene scene = first;
            for (SceneEllipsoid& ellipsoid : scene.ellipsoids) ellipsoid.axes *= 1.0 + 0.001 * i;
            for (ScenePoint& point : scene.points) point.radius *= 1.0 + 0.001 * i;
            renderer.set_scene(std::move(scene));
            ASSERT_TRUE(renderer.render());
        }
    };
    show(0, 40);
    const double before = mebibytes_in_use();
    show(40, 120);
    // A forgotten buffer or vertex array of every actor is 60 MiB here.
    EXPECT_LT(mebibytes_in_use() - before, 8.0);
}

}  // namespace
}  // namespace covaria::renderer_memory_test
