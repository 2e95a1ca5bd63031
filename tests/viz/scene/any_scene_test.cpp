// Scenes of any finite figures have an end: few ticks, bounds that can be drawn, and words for what is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/random_figures.h"
#include "tests/viz/stewart_scene.h"
#include "viz/scene/build_parts.h"
#include "viz/scene/build_scene.h"

namespace covaria::any_scene_test {
namespace {

Eigen::Vector3d anywhere(test::RandomFigures& figures) {
    const auto figure = [&] { return figures.below(3) == 0 ? figures.any() : figures.usual(); };
    return {figure(), figure(), figure()};
}

void expect_a_scene(const Scene& scene, const std::string& what) {
    const SceneBounds bounds = bounds_of(scene);
    EXPECT_TRUE(bounds.low.allFinite() && bounds.high.allFinite()) << what;
    EXPECT_LT((bounds.high - bounds.low).norm(), 1e17) << what << ": squares of it are single numbers";
    if (!scene.axes) return;
    for (const auto& ticks : scene.axes->ticks) {
        EXPECT_LE(ticks.size(), 64u) << what;
        EXPECT_TRUE(std::ranges::is_sorted(ticks, std::less{}, &AxisTick::at)) << what;
    }
}

TEST(Scenes, OfAnyPlacesHaveAnEnd) {
    test::RandomFigures figures(11);
    for (int i = 0; i < 500; ++i) {
        auto setup = test::stewart_setup(i % 50 == 0 ? 100 : 0,
                                         figures.below(3) == 0 ? 1.0 : figures.size_between(-150, 150));
        const std::size_t moved = 1 + figures.below(3);
        for (std::size_t k = 0; k < moved; ++k) {
            setup.layout.points[figures.below(setup.layout.points.size())].p_W = anywhere(figures);
            if (!setup.layout.frames.empty())
                setup.layout.frames[figures.below(setup.layout.frames.size())].X_WF.translation() =
                    anywhere(figures);
            if (!setup.layout.links.empty())
                setup.layout.links[figures.below(setup.layout.links.size())].to_W = anywhere(figures);
        }
        if (figures.below(3) == 0) {  // all of it, far away: nothing but single numbers between its ends
            const Eigen::Vector3d far = anywhere(figures);
            for (LayoutPoint& point : setup.layout.points) point.p_W += far;
            for (LayoutFrame& frame : setup.layout.frames) frame.X_WF.translation() += far;
        }
        SceneOptions options;
        if (figures.below(3) == 0) options.magnification = std::abs(figures.any());
        expect_a_scene(build_scene(setup.source(), options), "case " + std::to_string(i));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Scenes, SayWhatIsTooFarAwayToBeDrawn) {
    auto setup = test::stewart_setup(0);
    setup.layout.frames.front().X_WF.translation().x() = 1e57;
    const std::string name = setup.layout.frames.front().name;
    const Scene scene = build_scene(setup.source(), {});
    EXPECT_TRUE(std::ranges::any_of(scene.notes, [&](const std::string& note) {
        return note.find("not drawn, for it is farther away than 10¹² km: " + name) != std::string::npos;
    }));
    EXPECT_NE(find_item(scene, "point:b1"), nullptr) << "the rest is drawn";
    EXPECT_EQ(find_item(scene, "frame:" + name), nullptr);
    EXPECT_LT(scene.size, 10.0);
}

TEST(Scenes, OfAnyMapHaveFewColours) {
    test::RandomFigures figures(12);
    for (int i = 0; i < 20'000; ++i) {
        SceneMap map;
        std::tie(map.low, map.high) = figures.range();
        const auto ticks = detail::colour_ticks(map, {});
        ASSERT_LE(ticks.size(), 64u) << map.low << " to " << map.high;
        for (const AxisTick& tick : ticks)
            ASSERT_TRUE(std::isfinite(tick.at)) << map.low << " to " << map.high;
    }
}

}  // namespace
}  // namespace covaria::any_scene_test
