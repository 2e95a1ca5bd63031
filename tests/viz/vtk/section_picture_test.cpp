// Pictures with a section: what is before the plane is gone, what is behind it is seen.
#include <gtest/gtest.h>

#include "tests/viz/stewart_scene.h"
#include "tests/viz/vtk/picture_check.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::section_picture_test {
namespace {

constexpr int red = 0, blue = 2;

/// Two walls across y, an orange one before a blue one, as seen from the front.
Scene two_walls() {
    const auto wall = [](const char* name, double y, MeshColour colour) {
        auto triangles = std::make_shared<TriangleMesh>();
        const float at = static_cast<float>(y);
        triangles->corners = {-1, at, -1, 1, at, -1, 1, at, 1, -1, at, -1, 1, at, 1, -1, at, 1};
        for (std::size_t i = 0; i < triangles->corners.size(); i += 3)
            triangles->box.extend(Eigen::Map<const Eigen::Vector3f>(&triangles->corners[i]));
        SceneMesh mesh;
        mesh.item.id = std::string("mesh:") + name;
        mesh.triangles = triangles;
        mesh.colour = colour;
        return mesh;
    };
    Scene scene;
    scene.size = 3.0;
    scene.meshes = {wall("near", -0.5, MeshColour::red), wall("far", 0.5, MeshColour::blue)};
    return scene;
}

class SectionPicture : public testing::Test {
protected:
    SectionPicture() { renderer_.set_size(400, 300); }
    Image picture(const Scene& scene, const std::string& name, StandardView view = StandardView::front) {
        renderer_.set_scene(scene);
        renderer_.set_view(view);
        const auto image = renderer_.render(RenderQuality::full);
        EXPECT_TRUE(image) << (image ? "" : image.error().message.english());
        if (!image) return {};
        test::left_picture(*image, name);
        return *image;
    }
    bool is(const Image& image, const Eigen::Vector3d& at, int stronger, int weaker) {
        return test::coloured_near(image, renderer_.project(at), 4, stronger, weaker) > 60;
    }
    SceneRenderer renderer_;
};

TEST_F(SectionPicture, WhatIsBeforeThePlaneVanishesAndWhatIsBehindItStays) {
    Scene scene = two_walls();
    const Eigen::Vector3d left(-0.5, 0, 0), right(0.5, 0, 0);
    const Image whole = picture(scene, "section-none");
    EXPECT_TRUE(is(whole, left, red, blue) && is(whole, right, red, blue));
    scene.section = SectionPlane{1, 0.0, false};
    const Image opened = picture(scene, "section-opened");
    EXPECT_TRUE(is(opened, left, blue, red) && is(opened, right, blue, red));
    EXPECT_EQ(renderer_.pick(200, 150), "mesh:far");
    scene.section = SectionPlane{0, 0.0, true};
    const Image half = picture(scene, "section-half");
    EXPECT_TRUE(is(half, left, red, blue));
    EXPECT_FALSE(is(half, right, red, blue) || is(half, right, blue, red));
    scene.section.reset();
    EXPECT_EQ(picture(scene, "section-none-again").rgba, whole.rgba) << "it is whole again";
}

TEST_F(SectionPicture, SolidsAreOpenedAndAreFlatInside) {
    SceneOptions options;
    options.clouds = options.ellipsoids = options.labels = options.wall_histograms = false;
    Scene scene = build_scene(test::stewart_setup(10).source(), options);
    const Image whole = picture(scene, "section-platform-whole", StandardView::iso);
    const double z = find_item(scene, "point:p1")->position.z();
    scene.section = SectionPlane{2, z / 2, true};
    const Image opened = picture(scene, "section-platform", StandardView::iso);
    EXPECT_GT(test::difference(whole, opened).fraction, 0.008) << "the upper plate is gone";
    scene.section = SectionPlane{2, 10 * z, true};
    EXPECT_LT(test::difference(whole, picture(scene, "section-above", StandardView::iso)).fraction, 1e-3)
        << "a plane that cuts nothing changes nothing: no front of a solid is taken for its inside";
}

TEST_F(SectionPicture, DotsOfCloudsAndEllipsoidsAreCut) {
    SceneOptions options;
    options.labels = options.bodies = options.links = false;
    Scene scene = build_scene(test::stewart_setup(5000).source(), options);
    LayerVisibility layers;
    layers[Layer::clouds] = true;
    layers[Layer::legend] = false;
    renderer_.set_layers(layers);
    const SceneEllipsoid ellipsoid = scene.ellipsoids.front();
    const int colour = ellipsoid.role == Role::output ? blue : red;
    const Eigen::Vector3d half = 0.5 * ellipsoid.axes.row(0).norm() * Eigen::Vector3d::UnitX();
    scene.section = SectionPlane{0, ellipsoid.item.position.x(), true};
    renderer_.set_scene(scene);
    renderer_.set_view(StandardView::front);
    renderer_.zoom(10.0, renderer_.project(ellipsoid.item.position));
    const auto made = renderer_.render(RenderQuality::full);
    ASSERT_TRUE(made) << made.error().message.english();
    const Image& cut = *made;
    test::left_picture(cut, "section-cloud");
    const auto coloured = [&](const Eigen::Vector3d& at) {
        return test::coloured_near(cut, renderer_.project(at), 2, colour, 2 - colour);
    };
    EXPECT_GT(coloured(ellipsoid.item.position - half), 5);
    EXPECT_EQ(coloured(ellipsoid.item.position + half), 0);
}

}  // namespace
}  // namespace covaria::section_picture_test
