// Pictures of the Stewart platform, rendered with no display, and what must be seen in them.
#include "viz/vtk/scene_renderer.h"
#include "tests/core/result/changed_inputs.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "tests/viz/stewart_scene.h"
#include "tests/viz/vtk/picture_check.h"

namespace covaria::scene_renderer_test {
namespace {

constexpr int red = 0, green = 1, blue = 2;

Scene stewart(int trials = 3000, const SceneOptions& options = {}) {
    const auto setup = test::stewart_setup(trials);
    return build_scene(setup.source(), options);
}

Image picture(SceneRenderer& renderer, RenderQuality quality = RenderQuality::full) {
    auto image = renderer.render(quality);
    EXPECT_TRUE(image.has_value()) << (image ? "" : image.error().message.english());
    return image ? *image : Image{};
}

/// A renderer of the Stewart platform at 800 x 600.
struct StewartRenderer : SceneRenderer {
    explicit StewartRenderer(StandardView view = StandardView::iso, Scene scene = stewart()) {
        set_size(800, 600);
        set_scene(std::move(scene));
        set_view(view);
    }
};

TEST(SceneRenderer, NeedsNoDisplay) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    SceneRenderer renderer;
    const auto opened = renderer.open();
    EXPECT_TRUE(opened.has_value()) << (opened ? "" : opened.error().message.english());
}

TEST(SceneRenderer, MessagesStayOffTheTerminal) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string log;
    set_rendering_log([&](const std::string& message) { log += message; });
    {
        StewartRenderer renderer;
        picture(renderer);
    }
    set_rendering_log({});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(log, "");
}

TEST(SceneRenderer, ColoursAreWhereTheThingsAre) {
    StewartRenderer renderer;
    const Image image = picture(renderer);
    const auto at = [&](double x, double y, double z) { return renderer.project({x, y, z}); };
    const auto context = [&] { return test::left_picture(image, "colours"); };
    EXPECT_GT(test::coloured_near(image, at(-0.196 - 0.03, -0.111, 1.175 + 0.03), 6, red, blue), 60)
        << context();
    EXPECT_GT(test::coloured_near(image, at(-0.05, -0.02, 1.175), 6, blue, red), 60) << context();
    EXPECT_GT(test::coloured_near(image, at(0.08, 0, 0), 3, red, blue), 6) << "x axis; " << context();
    EXPECT_GT(test::coloured_near(image, at(0, 0.08, 0), 3, green, red), 6) << "y axis; " << context();
    EXPECT_GT(test::coloured_near(image, at(0, 0, 0.08), 3, blue, red), 6) << "z axis; " << context();
    EXPECT_EQ(test::coloured_near(image, {790, 300}, 6, blue, red), 0) << "the ground is neutral";
}

TEST(SceneRenderer, CaptionLegendAndScaleBarAreWritten) {
    StewartRenderer renderer;
    const Image image = picture(renderer);
    const auto context = [&] { return test::left_picture(image, "words"); };
    EXPECT_GT(test::dark_in(image, 10, 570, 220, 28), 50) << "caption; " << context();
    EXPECT_GT(test::dark_in(image, 10, 4, 140, 26), 60) << "group and legend; " << context();
    EXPECT_GT(test::dark_in(image, 600, 560, 195, 38), 80) << "scale bar; " << context();
    LayerVisibility layers;
    layers[Layer::legend] = layers[Layer::labels] = layers[Layer::axes] = false;
    renderer.set_layers(layers);
    const Image bare = picture(renderer);
    EXPECT_GT(test::dark_in(bare, 10, 570, 220, 28), 50) << "the caption stays while uncertainty is drawn";
    layers[Layer::ellipsoids] = layers[Layer::clouds] = false;
    renderer.set_layers(layers);
    EXPECT_EQ(test::dark_in(picture(renderer), 10, 570, 220, 28), 0);
}

TEST(SceneRenderer, LabelsAreWrittenBesideTheirPoints) {
    SceneOptions options;
    options.ellipsoids = options.clouds = options.bodies = false;
    StewartRenderer with(StandardView::iso, stewart(0, options));
    const Image labelled = picture(with);
    LayerVisibility layers;
    layers[Layer::labels] = false;
    with.set_layers(layers);
    const Image plain = picture(with);
    for (const char* id : {"point:b1", "point:b2", "point:b3", "point:p1", "point:p2", "point:p3"}) {
        const Pixel at = with.project(find_item(with.scene(), id)->position);
        const int x = static_cast<int>(at.x) - 45, y = static_cast<int>(at.y) - 35;
        EXPECT_GT(test::dark_in(labelled, x, y, 90, 70), test::dark_in(plain, x, y, 90, 70) + 15)
            << id << "; " << test::left_picture(labelled, "labels");
    }
}

TEST(SceneRenderer, ViewsShowTheirAxes) {
    StewartRenderer renderer(StandardView::top);
    Image image = picture(renderer);
    EXPECT_GT(test::coloured_near(image, renderer.project({0.08, 0, 1.175}), 3, red, blue), 10);
    EXPECT_GT(test::coloured_near(image, renderer.project({0, 0.13, 1.175}), 3, green, red), 10);
    renderer.set_view(StandardView::front);
    image = picture(renderer);
    EXPECT_GT(test::coloured_near(image, renderer.project({0.1, 0, 0}), 3, red, blue), 6);
    EXPECT_GT(test::coloured_near(image, renderer.project({0, 0, 0.1}), 3, blue, red), 6);
    renderer.set_view(StandardView::right);
    image = picture(renderer);
    EXPECT_GT(test::coloured_near(image, renderer.project({0, 0.1, 0}), 3, green, red), 6);
    EXPECT_GT(test::coloured_near(image, renderer.project({0, 0, 0.1}), 3, blue, red), 6);
}

TEST(SceneRenderer, OrbitPanAndZoomChangeThePicture) {
    StewartRenderer renderer;
    const Image before = picture(renderer, RenderQuality::moving);
    EXPECT_EQ(picture(renderer, RenderQuality::moving), before) << "nothing moved";
    const Camera start = renderer.camera();
    renderer.orbit(80, 20);
    EXPECT_GT(test::difference(picture(renderer, RenderQuality::moving), before).fraction, 0.01);
    renderer.set_camera(start);
    renderer.pan(40, 0);
    EXPECT_GT(test::difference(picture(renderer, RenderQuality::moving), before).fraction, 0.01);
    renderer.set_camera(start);
    renderer.zoom(1.5);
    EXPECT_GT(test::difference(picture(renderer, RenderQuality::moving), before).fraction, 0.01);
    renderer.set_camera(start);
    EXPECT_EQ(picture(renderer, RenderQuality::moving), before) << "and back";
}

TEST(SceneRenderer, PickReturnsThePointUnderThePixel) {
    StewartRenderer renderer;
    const Pixel at = renderer.project({0.344, 0.196, 0});
    ASSERT_EQ(renderer.pick(at.x, at.y).value_or(""), "point:b2");
    const SceneItem* item = find_item(renderer.scene(), "point:b2");
    EXPECT_EQ(item->source.path, "/base_points/rows/1");
    EXPECT_EQ(renderer.pick(790, 10), std::nullopt);
    const Eigen::Vector3d dragged = renderer.world_at(at.x + 10, at.y, item->position);
    const Pixel there = renderer.project(dragged);
    EXPECT_NEAR(there.x, at.x + 10, 1e-6);
    EXPECT_NEAR(there.y, at.y, 1e-6);
}

TEST(SceneRenderer, SelectionIsRinged) {
    StewartRenderer renderer;
    const Image before = picture(renderer);
    renderer.set_selected("point:b2");
    const Image after = picture(renderer);
    const auto d = test::difference(before, after);
    EXPECT_GT(d.fraction, 2e-4) << test::left_picture(after, "selection");
    EXPECT_LT(d.fraction, 2e-2);
    renderer.set_selected("point:unheard of");
    EXPECT_EQ(picture(renderer), before);
}

TEST(SceneRenderer, PaletteAndSceneCanChange) {
    StewartRenderer renderer;
    LayerVisibility layers;
    layers[Layer::clouds] = true;
    renderer.set_layers(layers);
    const Image light = picture(renderer);
    renderer.set_palette(ScenePalette::dark);
    const Image dark = picture(renderer);
    EXPECT_GT(light.at(790, 300)[0], 230);
    EXPECT_LT(dark.at(790, 300)[0], 60);
    renderer.set_palette(ScenePalette::light);
    EXPECT_EQ(picture(renderer), light);
    SceneOptions options;
    options.clouds = false;
    renderer.set_scene(stewart(3000, options));
    const Image without = picture(renderer);
    renderer.set_scene(stewart());
    EXPECT_GT(test::difference(without, light).fraction, 0.005);
    EXPECT_EQ(picture(renderer), light) << "a rebuilt layer leaves no trace";
}

TEST(SceneRenderer, HiddenLayersAreNotDrawn) {
    StewartRenderer renderer;
    LayerVisibility every;
    every.shown.fill(true);
    renderer.set_layers(every);
    const Image all = picture(renderer);
    for (std::size_t i = 0; i < layer_count; ++i) {
        if (static_cast<Layer>(i) == Layer::links || static_cast<Layer>(i) == Layer::vectors ||
            static_cast<Layer>(i) == Layer::map || static_cast<Layer>(i) == Layer::ellipsoids_before ||
            static_cast<Layer>(i) == Layer::meshes)
            continue;  // none here
        LayerVisibility layers = every;
        layers[static_cast<Layer>(i)] = false;
        renderer.set_layers(layers);
        EXPECT_NE(picture(renderer), all) << layer_key(static_cast<Layer>(i));
    }
}

TEST(SceneRenderer, EllipsoidsBeforeAreALayerOfTheirOwn) {
    const auto now = test::stewart_setup(0), was = test::stewart_setup(0, 2.0);
    const ResultComparison compared = compare_results(std::make_shared<UncertaintyResult>(was.result),
                                                      std::make_shared<UncertaintyResult>(now.result));
    SceneSource source = now.source();
    source.compared = &compared;
    StewartRenderer renderer(StandardView::iso, build_scene(source, {}));
    const Image both = picture(renderer);
    LayerVisibility layers;
    layers[Layer::ellipsoids_before] = false;
    renderer.set_layers(layers);
    const Image without = picture(renderer);
    EXPECT_NE(without, both);
    layers[Layer::ellipsoids_before] = true;
    layers[Layer::ellipsoids] = false;
    renderer.set_layers(layers);
    EXPECT_GT(test::dark_in(picture(renderer), 10, 570, 220, 28), 50) << "the caption is theirs, too";
}

TEST(SceneRenderer, NothingToSeeIsStillAPicture) {
    SceneRenderer renderer;
    renderer.set_size(64, 48);
    EXPECT_EQ(picture(renderer).width, 64);
    renderer.set_scene(Scene{});
    renderer.fit();
    renderer.set_view(StandardView::top);
    EXPECT_EQ(renderer.pick(10, 10), std::nullopt);
    EXPECT_EQ(picture(renderer).height, 48);
    const auto exact = test::stewart_setup(0, 0.0);
    renderer.set_scene(build_scene(exact.source(), {}));
    EXPECT_FALSE(picture(renderer).empty());
    SceneSource layout_only = exact.source();
    layout_only.result = nullptr;
    renderer.set_scene(build_scene(layout_only, {}));
    EXPECT_FALSE(picture(renderer).empty());
    renderer.set_size(1, 1);
    EXPECT_EQ(picture(renderer).rgba.size(), 4u);
}

TEST(SceneRenderer, EverySizeFillsThePicture) {
    StewartRenderer renderer;
    for (const PictureSize size : {PictureSize{400, 300}, PictureSize{301, 333}, PictureSize{2560, 1600}}) {
        renderer.set_size(size.width, size.height);
        renderer.fit();
        for (RenderQuality quality : {RenderQuality::moving, RenderQuality::fine}) {
            const Image image = picture(renderer, quality);
            ASSERT_EQ(image.width, size.width);
            ASSERT_EQ(image.height, size.height);
            const Pixel on_cloud = renderer.project({-0.05, -0.02, 1.175});
            EXPECT_GT(test::coloured_near(image, on_cloud, 4, blue, red), 20) << size.width;
        }
    }
}

TEST(SceneRenderer, SolidsStandBeforeTheFloorWhileTheCameraMoves) {
    SceneOptions options;
    options.clouds = options.ellipsoids = options.labels = options.wall_histograms = false;
    StewartRenderer renderer(StandardView::iso, stewart(10, options));
    const Image still = picture(renderer), moving = picture(renderer, RenderQuality::moving);
    EXPECT_LT(test::difference(still, moving).fraction, 0.01)
        << test::left_picture(still, "solids-still") << test::left_picture(moving, "solids-moving");
}

TEST(SceneRenderer, DegenerateEllipsoidsAreDrawn) {
    auto setup = test::stewart_setup(0);
    setup.result.covariance.set(2, 0.0);
    test::change_inputs(setup.result, [](InputSet& inputs) {
        for (std::size_t i = 9; i < 12; ++i)  // p1: a line along x
            inputs.components[i].held = i != 9;
    });
    StewartRenderer renderer(StandardView::top, build_scene(setup.source(), {}));
    const Image image = picture(renderer);
    const Pixel on_disc = renderer.project({-0.04, 0.02, 1.175});
    EXPECT_GT(test::coloured_near(image, on_disc, 3, blue, red), 5) << test::left_picture(image, "flat");
}

TEST(SceneRenderer, SeveralRenderersInSeveralThreads) {
    StewartRenderer here;
    const Image expected = picture(here);
    std::vector<Image> images(3);
    {
        std::vector<std::jthread> threads;
        for (Image& image : images)
            threads.emplace_back([&image] {
                StewartRenderer renderer;
                for (int i = 0; i < 3; ++i) image = picture(renderer);
            });
    }
    for (const Image& image : images) EXPECT_EQ(image, expected);
    Image moved;
    std::jthread([&] { moved = picture(here); }).join();
    EXPECT_EQ(moved, expected) << "a renderer may be used from another thread";
}

TEST(SceneRenderer, Baselines) {
    StewartRenderer renderer;
    EXPECT_TRUE(test::matches_baseline(picture(renderer, RenderQuality::fine), "stewart-iso-light"));
    renderer.set_palette(ScenePalette::dark);
    renderer.set_selected("point:p2");
    renderer.set_view(StandardView::top);
    EXPECT_TRUE(test::matches_baseline(picture(renderer, RenderQuality::fine), "stewart-top-dark"));
}

}  // namespace
}  // namespace covaria::scene_renderer_test
