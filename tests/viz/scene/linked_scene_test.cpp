// Points that an analysis takes from others show the uncertainty that they have there.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "viz/scene/analysis_scene.h"

namespace covaria::linked_scene_test {
namespace {

TEST(LinkedScene, PlacesThatARobotIsIdentifiedFromHaveEllipsoids) {
    Project project = load_project(data_directory() / "projects/chain.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) {
        analysis.options.method = Method::monte_carlo;
        analysis.options.trials = 200;
    }
    const auto made = MadeProject::make(std::move(project));
    const auto prepared = made->analysis("identification");
    ASSERT_TRUE(prepared);
    const auto result = run_analysis(*prepared);
    ASSERT_TRUE(result);
    const auto scene = analysis_scene(*prepared, &*result, {});
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->ellipsoids.size(), prepared->linked_points.size());
    EXPECT_GE(scene->ellipsoids.size(), 6u);
    for (const SceneEllipsoid& ellipsoid : scene->ellipsoids) {
        EXPECT_EQ(ellipsoid.role, Role::input);
        ASSERT_TRUE(ellipsoid.item.u && ellipsoid.item.U);
        EXPECT_GT(ellipsoid.item.u->minCoeff(), 0.0);
    }
    EXPECT_TRUE(scene->clouds.empty()) << "the trials of others are not drawn";
    EXPECT_TRUE(scene->caption.starts_with("ellipsoids 95")) << scene->caption;
    const auto nothing = analysis_scene(*prepared, nullptr, {});
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->ellipsoids.empty());
}

}  // namespace
}  // namespace covaria::linked_scene_test
