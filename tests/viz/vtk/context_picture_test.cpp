// Pictures with a context mesh: its colour is where it stands, and gone where it is hidden.
#include <gtest/gtest.h>

#include "tests/stl_files.h"
#include "tests/viz/stewart_scene.h"
#include "tests/viz/vtk/picture_check.h"
#include "viz/scene/visibility.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::context_picture_test {
namespace {

constexpr int red = 0, blue = 2;

/// A blue wall beside the platform, in millimetres, turned about z by a right angle.
LayoutMesh wall() {
    auto triangles = std::make_shared<TriangleMesh>();
    for (const test::StlTriangle& triangle : test::rectangle(300, -700, 900, -500, 900))
        triangles->corners.insert(triangles->corners.end(), triangle.begin(), triangle.end());
    for (std::size_t i = 0; i < triangles->corners.size(); i += 3)
        triangles->box.extend(Eigen::Map<const Eigen::Vector3f>(&triangles->corners[i]));
    LayoutMesh mesh{.name = "wall", .triangles = triangles};
    mesh.scale = 1e-3;
    mesh.X_WM.linear() = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    mesh.colour = MeshColour::blue;
    mesh.opacity = 0.8;
    return mesh;
}
const Eigen::Vector3d on_wall(0.6, 0.7, 0.9);

Scene scene_with(const LayoutMesh& mesh) {
    SceneOptions options;
    options.clouds = options.ellipsoids = options.labels = options.wall_histograms = false;
    options.context = {mesh};
    return build_scene(test::stewart_setup(10).source(), options);
}

class ContextPicture : public testing::Test {
protected:
    ContextPicture() { renderer_.set_size(800, 600); }
    int blue_on_wall(const Scene& scene, const char* name) {
        renderer_.set_scene(scene);
        const auto image = renderer_.render(RenderQuality::full);
        EXPECT_TRUE(image) << (image ? "" : image.error().message.english());
        if (!image) return -1;
        test::left_picture(*image, name);
        return test::coloured_near(*image, renderer_.project(on_wall), 4, blue, red);
    }
    SceneRenderer renderer_;
};

TEST_F(ContextPicture, StandsWhereItIsPlaced) {
    const Scene scene = scene_with(wall());
    for (const StandardView view : {StandardView::top, StandardView::bottom}) {
        renderer_.set_scene(scene);
        renderer_.set_view(view);
        renderer_.zoom(0.5);  // the picture is fitted to the platform, not to the wall
        EXPECT_GT(blue_on_wall(scene, "context-shown"), 40) << "seen from both sides";
        EXPECT_EQ(blue_on_wall(visible_part(scene, {{"mesh:wall"}, {}}), "context-hidden"), 0);
        EXPECT_GT(blue_on_wall(scene, "context-again"), 40);
    }
    LayerVisibility layers;
    layers[Layer::meshes] = false;
    renderer_.set_layers(layers);
    EXPECT_EQ(blue_on_wall(scene, "context-layer"), 0);
}

TEST_F(ContextPicture, FollowsItsColourAndPlace) {
    renderer_.set_scene(scene_with(wall()));
    renderer_.set_view(StandardView::top);
    renderer_.zoom(0.5);
    LayoutMesh moved = wall();
    moved.X_WM.translation().x() = -10.0;
    EXPECT_EQ(blue_on_wall(scene_with(moved), "context-moved"), 0);
    EXPECT_GT(blue_on_wall(scene_with(wall()), "context-back"), 40);
    LayoutMesh grey = wall();
    grey.colour = MeshColour::grey;
    EXPECT_EQ(blue_on_wall(scene_with(grey), "context-grey"), 0);
}

TEST_F(ContextPicture, AHallIsNotCutOff) {
    LayoutMesh far = wall();
    far.scale = 1.0;  // a hundred times as far from the eye as the platform is large
    far.X_WM.translation() = Eigen::Vector3d(0, 0, -1000.0);
    far.X_WM.linear().setIdentity();
    const Scene scene = scene_with(far);
    renderer_.set_scene(scene);
    renderer_.set_view(StandardView::top);
    Camera camera = renderer_.camera();
    camera.focal_point = Eigen::Vector3d(600, -600, 0);
    renderer_.set_camera(camera);
    const auto image = renderer_.render(RenderQuality::full);
    ASSERT_TRUE(image);
    EXPECT_GT(test::coloured_near(*image, {400, 300}, 4, blue, red), 40)
        << test::left_picture(*image, "hall");
}

}  // namespace
}  // namespace covaria::context_picture_test
