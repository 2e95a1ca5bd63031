// Context meshes in scenes: around every layout, outside its box, hidden and picked like other items.
#include <gtest/gtest.h>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "tests/fresh_folder.h"
#include "tests/stl_files.h"
#include "tests/viz/stewart_scene.h"
#include "viz/scene/analysis_scene.h"
#include "viz/scene/context_meshes.h"
#include "viz/scene/dump_scene.h"
#include "viz/scene/pick.h"
#include "viz/scene/visibility.h"

namespace covaria::context_scene_test {
namespace {

/// A floor of 20 m by 20 m, one metre below the origin.
LayoutMesh floor_mesh() {
    auto triangles = std::make_shared<TriangleMesh>();
    for (const test::StlTriangle& triangle : test::rectangle(-10'000, -10'000, 10'000, 10'000, 0))
        triangles->corners.insert(triangles->corners.end(), triangle.begin(), triangle.end());
    triangles->box.extend(Eigen::Vector3f(-10'000, -10'000, 0)).extend(Eigen::Vector3f(10'000, 10'000, 0));
    LayoutMesh mesh{.name = "floor", .triangles = triangles};
    mesh.scale = 1e-3;
    mesh.X_WM.translation().z() = -1.0;
    mesh.opacity = 0.25;
    mesh.source = {.path = "/placement", .asset = "hall"};
    return mesh;
}

Scene stewart(std::vector<LayoutMesh> context) {
    SceneOptions options;
    options.context = std::move(context);
    return build_scene(test::stewart_setup(200).source(), options);
}

TEST(ContextScene, AMeshIsAddedAndChangesNothingElse) {
    Scene with = stewart({floor_mesh()});
    ASSERT_EQ(with.meshes.size(), 1U);
    EXPECT_EQ(with.meshes.front().item.id, "mesh:floor");
    EXPECT_EQ(with.meshes.front().item.source.asset, "hall");
    EXPECT_NE(dump_scene(with).find("mesh mesh:floor at (0 0 -1000) from hall/placement triangles 2"),
              std::string::npos);
    with.meshes.clear();
    EXPECT_EQ(with, stewart({}));
}

TEST(ContextScene, ThePictureIsFittedToWhatIsMeasured) {
    const Scene with = stewart({floor_mesh()});
    EXPECT_EQ(bounds_of(with).high, bounds_of(stewart({})).high);
    EXPECT_EQ(bounds_with_meshes(with).high.x(), 10.0);
    EXPECT_EQ(bounds_with_meshes(with).low.z(), std::min(-1.0, bounds_of(with).low.z()));
}

TEST(ContextScene, AMeshAloneIsItsOwnBox) {
    Layout layout;
    layout.meshes = {floor_mesh()};
    const Scene scene = build_scene({&layout, nullptr, nullptr, nullptr, ""}, {});
    EXPECT_GT(scene.size, 28.0);
    EXPECT_TRUE(scene.axes);
    SceneOptions options;
    options.context = {floor_mesh()};
    const Layout nothing;
    EXPECT_TRUE(build_scene({&nothing, nullptr, nullptr, nullptr, ""}, options).meshes.empty())
        << "an analysis that is nowhere in space has no scene";
}

TEST(ContextScene, IsHiddenAndShownAlone) {
    const Scene scene = stewart({floor_mesh()});
    EXPECT_TRUE(visible_part(scene, {{"mesh:floor"}, {}}).meshes.empty());
    const Scene alone = visible_part(scene, {{}, "mesh:floor"});
    EXPECT_EQ(alone.meshes.size(), 1U);
    EXPECT_TRUE(alone.points.empty());
    EXPECT_GT(bounds_of(alone).high.x(), 9.9);
}

TEST(ContextScene, IsPickedWhereNothingElseIs) {
    const Scene scene = stewart({floor_mesh()});
    const PictureSize size{800, 600};
    const Camera camera = view_of(bounds_with_meshes(scene), StandardView::top, size);
    const auto picked = [&](const Eigen::Vector3d& p, bool shown = true) {
        return pick_item(
                   scene, camera, size, project(camera, size, p),
                   [&](Layer layer) { return shown || layer != Layer::meshes; }, 3.0)
            .value_or("");
    };
    EXPECT_EQ(picked({8, 8, 0}), "mesh:floor");
    EXPECT_EQ(picked({8, 8, 0}, false), "");
    EXPECT_EQ(picked({11, 0, 0}), "") << "beside it";
    EXPECT_EQ(picked(scene.points.front().item.position), scene.points.front().item.id);
}

TEST(ContextScene, EveryAnalysisOfAProjectShowsIt) {
    const auto file = test::fresh_folder("context-scene") / "hall.stl";
    ASSERT_TRUE(write_file_atomically(file, test::binary_stl(test::rectangle(-5, -5, 5, 5, 0))));
    LoadedProject loaded = load_project(data_directory() / "projects/stewart-platform.covaria");
    AssetEntry hall{"hall", "context-mesh", "Hall 3", {}, {}};
    hall.setup.values["file"] = file.string();
    loaded.project.assets.push_back(hall);
    const auto made = MadeProject::make(loaded.project);
    SceneOptions options;
    options.context = context_meshes(*made);
    ASSERT_EQ(options.context.size(), 1U);
    EXPECT_EQ(options.context.front().name, "Hall 3");
    for (const AnalysisEntry& entry : loaded.project.analyses) {
        const auto scene = analysis_scene(*made->analysis(entry.id), nullptr, options);
        ASSERT_TRUE(scene);
        ASSERT_EQ(scene->meshes.size(), 1U) << entry.id;
        EXPECT_EQ(scene->meshes.front().item.source.asset, "hall");
    }
}

}  // namespace
}  // namespace covaria::context_scene_test
