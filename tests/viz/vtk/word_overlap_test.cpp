// No word of a picture stands on another: every example, from every side, in pictures of four sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "core/model/has_layout.h"
#include "viz/scene/analysis_scene.h"
#include "viz/vtk/overlay.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::word_overlap_test {
namespace {

namespace fs = std::filesystem;

struct View {
    StandardView view = StandardView::iso;
    PictureSize size;
    double ratio = 1.0;
    bool perspective = false;
};

std::vector<View> views() {
    std::vector<View> all;
    for (std::size_t i = 0; i < standard_view_count; ++i)
        for (const bool perspective : {false, true}) {
            const auto view = static_cast<StandardView>(i);
            all.push_back({view, {1280, 800}, 1.0, perspective});
            all.push_back({view, {564, 324}, 1.0, perspective});
            all.push_back({view, {500, 400}, 1.0, perspective});
            all.push_back({view, {2560, 1600}, 2.0, perspective});
        }
    return all;
}

struct Counts {
    std::size_t words = 0;
    std::vector<std::string> overlaps, nameless, covered, over_bodies, over_corners;
    std::size_t labels = 0;
};

std::string view_words(const Scene& scene, const View& view) {
    return scene.title + ", " + scene.group + ", view " + std::to_string(int(view.view)) + ", width " +
           std::to_string(view.size.width) + ": ";
}

/// Middles of what stands in the scene.
std::vector<Eigen::Vector3d> centres_of(const Scene& scene) {
    std::vector<Eigen::Vector3d> centres;
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty()) centres.push_back(body.item.position);
    for (const SceneLink& link : scene.links)
        if (link.radius > 0) centres.push_back((link.from + link.to) / 2);
    for (const ScenePoint& point : scene.points) centres.push_back(point.item.position);
    return centres;
}

void count_labels(const detail::Overlay& overlay, const detail::OverlayView& look, const Scene& scene,
                  const View& view, Counts& counts) {
    const std::vector<Eigen::Vector3d> centres = centres_of(scene);
    for (const auto& word : overlay.words()) {
        if (!word.is_label) continue;
        ++counts.labels;
        if (word.rect.overlaps(look.reserved))
            counts.over_corners.push_back(view_words(scene, view) + to_unicode(word.text));
        for (const Eigen::Vector3d& centre : centres) {
            const Pixel at = project(look.camera, view.size, centre);
            if (word.rect.overlaps({at.x, at.y, 1e-6, 1e-6}))
                counts.over_bodies.push_back(view_words(scene, view) + to_unicode(word.text));
        }
    }
}

/// Writes the words of a picture and counts those that share pixels, and the axes that are to be seen without
/// their names.
void count(SceneRenderer& renderer, const View& view, detail::TextMasks& masks, Counts& counts) {
    renderer.set_size(view.size.width, view.size.height);
    renderer.set_pixel_ratio(view.ratio);
    renderer.set_perspective(view.perspective);
    renderer.set_view(view.view);
    const Scene& scene = renderer.scene();
    Image image{view.size.width, view.size.height, {}};
    image.rgba.assign(std::size_t(4) * std::size_t(view.size.width) * std::size_t(view.size.height), 255);
    detail::OverlayView look;
    look.camera = renderer.camera();
    look.ratio = view.ratio;
    const double cube = 64.0 * view.ratio, margin = 16.0 * view.ratio;
    look.reserved = {view.size.width - margin - cube, margin, cube, cube};
    detail::Overlay overlay(scene, look, image, masks);
    overlay.paint();
    const auto& words = overlay.words();
    counts.words += words.size();
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (words[i].rect.overlaps(words[j].rect))
                counts.overlaps.push_back(view_words(scene, view) + to_unicode(words[i].text) + " on " +
                                          to_unicode(words[j].text));
    count_labels(overlay, look, scene, view, counts);
    look.covered = 40.0 * view.ratio;
    look.layers.shown.fill(true);
    detail::Overlay covered(scene, look, image, masks);
    covered.paint();
    const double foot = view.size.height - look.covered;
    for (const auto& word : covered.words())
        if (word.rect.y < view.size.height && word.rect.y + word.rect.height > foot)
            counts.covered.push_back(view_words(scene, view) + to_unicode(word.text));
    look.layers.shown[static_cast<std::size_t>(Layer::labels)] = false;  // they come first
    const LayerVisibility before = renderer.layers();
    renderer.set_layers(look.layers);
    renderer.set_view(view.view);                 // leaves room for axes, which are shown
    const bool is_small = view.size.width < 600;  // the legend of all layers takes a third of it
    look.camera = renderer.camera();
    detail::Overlay bare(scene, look, image, masks);
    bare.paint();
    for (const int axis : {0, 1, 2}) {
        const std::string name = std::string("xyz").substr(std::size_t(axis), 1);
        const bool from_its_end = std::abs(look.camera.direction[axis]) > 0.9;
        const auto is_name = [&](const auto& word) {
            const std::string text = to_unicode(word.text);
            return word.role == Role::text && !word.is_label &&
                   (text == name || text.starts_with(name + " / "));
        };
        if (scene.axes && !is_small && !from_its_end && std::ranges::none_of(bare.words(), is_name))
            counts.nameless.push_back(view_words(scene, view) + name);
    }
    renderer.set_layers(before);
}

/// The first and the last group of every analysis that stands in space.
std::vector<Scene> scenes_of(const fs::path& file) {
    Project project = load_project(file).project;
    for (AnalysisEntry& analysis : project.analyses) {
        analysis.options.method = Method::monte_carlo;
        analysis.options.trials = 2000;
    }
    const auto made = MadeProject::make(std::move(project));
    std::vector<Scene> scenes;
    for (const AnalysisEntry& entry : made->project().analyses) {
        const auto prepared = made->analysis(entry.id);
        if (!prepared || !has_layout(*prepared->model, prepared->inputs)) continue;
        const auto result = run_analysis(*prepared);
        EXPECT_TRUE(result) << file << " " << entry.id;
        if (!result) continue;
        std::vector<Name> groups = groups_of(prepared->model->outputs());
        if (groups.empty()) groups = {""};
        for (const Name& group : {groups.front(), groups.back()}) {
            SceneOptions options;
            options.group = group;
            auto scene = analysis_scene(*prepared, &*result, options);
            EXPECT_TRUE(scene) << file << " " << entry.id;
            if (!scene) continue;
            scenes.push_back(*std::move(scene));
            // A copy has the colour bar of a study, and the remark of a preview.
            Scene map = scenes.back();
            map.map = SceneMap{.title = "u(3D), platform / mm", .positions = {Eigen::Vector3d::Zero()}};
            map.map->values = {0.5};
            map.map->shown = {false};
            map.map->ticks = {{0.25, "0.25"}, {0.5, "0.50"}, {0.75, "0.75"}};
            map.caption += "; preview of 12 000 trials";
            scenes.push_back(std::move(map));
        }
    }
    return scenes;
}

TEST(Words, NoneStandsOnAnotherInAnyExample) {
    Counts counts;
    detail::TextMasks masks;
    SceneRenderer renderer;
    std::size_t scenes = 0;
    for (const auto& file : fs::directory_iterator(fs::path(COVARIA_SOURCE_DIR) / "projects")) {
        if (file.path().extension() != ".covaria") continue;
        for (const Scene& scene : scenes_of(file.path())) {
            ++scenes;
            renderer.set_scene(scene);
            for (const View& view : views()) count(renderer, view, masks, counts);
        }
    }
    EXPECT_GE(scenes, 12U);
    EXPECT_GE(counts.words, 5'000U);
    for (std::size_t i = 0; i < std::min<std::size_t>(counts.overlaps.size(), 30); ++i)
        ADD_FAILURE() << counts.overlaps[i];
    EXPECT_EQ(counts.overlaps.size(), 0U);
    EXPECT_GE(counts.labels, 1'000U);
    EXPECT_EQ(counts.over_bodies, std::vector<std::string>{});
    EXPECT_EQ(counts.over_corners, std::vector<std::string>{});
    EXPECT_EQ(counts.nameless, std::vector<std::string>{});
    EXPECT_EQ(counts.covered, std::vector<std::string>{});
}

TEST(Words, ALabelWithoutRoomIsLeftOutAndComesWhenZoomed) {
    Scene scene;
    scene.size = 1.0;
    for (int i = 0; i < 60; ++i) {
        const Eigen::Vector3d at(i / 60.0, 0, 0.2 * i / 60.0);
        scene.points.push_back({.item = {.id = std::to_string(i), .position = at}, .radius = 1e-3});
        scene.labels.push_back({"target " + std::to_string(i), at, 1e-3, Role::text, 50, std::to_string(i)});
    }
    detail::TextMasks masks;
    detail::OverlayView look;
    look.camera = view_of(bounds_of(scene), StandardView::front, {564, 324});
    const auto words = [&] {
        Image image{564, 324, std::vector<std::uint8_t>(std::size_t(4) * 564 * 324, 255)};
        detail::Overlay overlay(scene, look, image, masks);
        overlay.paint();
        std::vector<std::string> texts;
        for (const auto& word : overlay.words()) texts.push_back(to_unicode(word.text));
        return texts;
    };
    const auto has = [](const std::vector<std::string>& texts, const std::string& text) {
        return std::find(texts.begin(), texts.end(), text) != texts.end();
    };
    const auto all = words();
    EXPECT_LT(all.size(), 50U);
    EXPECT_GT(all.size(), 10U);
    for (int i = 0; i < 60; ++i) {
        const std::string name = "target " + std::to_string(i);
        if (has(all, name)) continue;
        look.camera.focal_point = scene.points[std::size_t(i)].item.position;
        look.camera.half_height = 0.02;
        EXPECT_TRUE(has(words(), name)) << name;
    }
}

std::vector<std::string> words_of(const Scene& scene, const detail::OverlayView& look, PictureSize size) {
    detail::TextMasks masks;
    Image image{size.width, size.height, {}};
    image.rgba.assign(std::size_t(4) * std::size_t(size.width) * std::size_t(size.height), 255);
    detail::Overlay overlay(scene, look, image, masks);
    overlay.paint();
    std::vector<std::string> texts;
    for (const auto& word : overlay.words()) texts.push_back(to_unicode(word.text));
    return texts;
}

TEST(Words, LabelsAtOnePlaceAreOneLabel) {
    Scene scene;
    scene.size = 1.0;
    for (const char* name : {"axis 5", "axis 6"})
        scene.labels.push_back({name, Eigen::Vector3d::Zero(), 0.01, Role::quiet_text, 20, name});
    scene.labels.push_back({"tool", Eigen::Vector3d::Zero(), 0.01, Role::text, 50, "tool"});
    scene.labels.push_back({"axis 4", Eigen::Vector3d(0.3, 0, 0), 0.01, Role::quiet_text, 20, "axis 4"});
    detail::OverlayView look;
    look.camera = view_of({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, StandardView::front, {564, 324});
    auto words = words_of(scene, look, {564, 324});
    std::ranges::sort(words);
    EXPECT_EQ(words, (std::vector<std::string>{"axis 4", "axis 5, axis 6", "tool"}));
    look.selected = "axis 6";  // it stands out
    words = words_of(scene, look, {564, 324});
    EXPECT_TRUE(std::ranges::count(words, "axis 5") == 1 && std::ranges::count(words, "axis 6") == 1);
}

// A tube, or a thin line of sight, across the usual places of a label.
class LabelBesideALink : public testing::TestWithParam<double> {};

TEST_P(LabelBesideALink, KeepsOffIt) {
    Scene scene;
    scene.size = 1.0;
    SceneLink& link = scene.links.emplace_back();
    link.to = {0.4, 0, 0.4};
    link.radius = GetParam();
    scene.labels.push_back({"joint", Eigen::Vector3d::Zero(), 0.01, Role::text, 20, ""});
    detail::OverlayView look;
    const PictureSize size{800, 600};
    look.camera = view_of({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, StandardView::front, size);
    detail::TextMasks masks;
    Image image{size.width, size.height, {}};
    image.rgba.assign(std::size_t(4) * 800 * 600, 255);
    detail::Overlay overlay(scene, look, image, masks);
    overlay.paint();
    ASSERT_EQ(overlay.words().size(), 1U);
    const ScreenRect& rect = overlay.words().front().rect;
    for (double along = 0.0; along <= 1.0; along += 0.05) {
        const Pixel at = project(look.camera, size, along * scene.links[0].to);
        EXPECT_FALSE(rect.overlaps({at.x, at.y, 1e-6, 1e-6})) << along;
    }
}

INSTANTIATE_TEST_SUITE_P(Words, LabelBesideALink, testing::Values(0.03, 0.0));

// An instrument so near to an axis of the picture that its label would run across.
TEST(Words, ALabelKeepsOffTheAxes) {
    Scene scene;
    scene.size = 1.0;
    scene.axes = SceneAxes{.low = {-0.5, -0.5, -0.5}, .high = {0.5, 0.5, 0.5}};
    detail::OverlayView look;
    look.layers[Layer::axes] = true;
    const PictureSize size{800, 600};
    look.camera = view_of(bounds_of(scene), StandardView::front, size, 50.0);
    const double axis = project(look.camera, size, {-0.5, 0, 0}).x;
    detail::TextMasks masks;
    for (const double x : {-0.49, -0.45, -0.4}) {
        scene.labels = {{"Laser tracker", {x, 0, 0.3}, 0.01, Role::text, 30, ""}};
        scene.links.resize(1);  // stands on the other side of it
        scene.links[0].from = {x + 0.02, 0, -0.5};
        scene.links[0].to = {x + 0.02, 0, 0.29};
        scene.links[0].radius = 0.01;
        Image image{size.width, size.height, {}};
        image.rgba.assign(std::size_t(4) * 800 * 600, 255);
        detail::Overlay overlay(scene, look, image, masks);
        overlay.paint();
        ASSERT_FALSE(overlay.words().empty());
        const ScreenRect& rect = overlay.words().back().rect;
        EXPECT_FALSE(rect.overlaps({axis, 0, 1e-6, 600})) << x;
    }
}

// A pane of the window: swatches go on in the next row, and a remark is broken.
TEST(Words, ANarrowPictureHasItsLegendInRows) {
    Scene scene;
    scene.size = 1.0;
    for (const char* name : {"out", "in", "before", "force, own scale"})
        scene.legend.push_back({LegendMark::ellipsoid, Role::output, name});
    scene.notes = {"uncertainty drawn at 12 of 400 points of this network"};
    const auto rows = [&](PictureSize size) {
        detail::TextMasks masks;
        std::set<double> tops;
        for (const auto& line : detail::head_lines(scene, {}, 1.0, size.width, masks)) {
            EXPECT_LT(line.x, 0.6 * size.width);
            tops.insert(line.y);
        }
        return tops.size();
    };
    EXPECT_EQ(rows({1280, 800}), 2U);
    EXPECT_GT(rows({260, 300}), 3U);
    EXPECT_GE(words_of(scene, {}, {260, 300}).size(), 6U);
}

// The remark of a preview was cut at the right.
TEST(Words, ALongCaptionIsBrokenIntoLines) {
    Scene scene;
    scene.size = 1.0;
    scene.caption =
        "ellipsoids 95 %, × 2000 with some more words; Preview with 12 000 of 1 000 000 trials of all";
    const auto lines = words_of(scene, {}, {460, 300});
    EXPECT_EQ(lines.size(), 2U);
    std::string all;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) all += (all.empty() ? "" : " ") + *line;
    EXPECT_EQ(all, scene.caption);
    EXPECT_EQ(words_of(scene, {}, {1280, 800}).size(), 1U);
}

// Lines of sight on all sides of a label: what is behind it does not show through its letters.
TEST(Words, ALabelThatCoversLinesHasAGround) {
    Scene scene;
    scene.size = 1.0;
    for (int i = -20; i <= 20; ++i)
        scene.links.push_back({.item = {}, .from = {-0.4, 0, 0.02 * i}, .to = {0.4, 0, 0.02 * i}});
    scene.labels.push_back({"L          L", Eigen::Vector3d::Zero(), 0.01, Role::text, 20, ""});
    detail::OverlayView look;
    const PictureSize size{800, 600};
    look.camera = view_of({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, StandardView::front, size);
    detail::TextMasks masks;
    Image image{size.width, size.height, {}};
    image.rgba.assign(std::size_t(4) * 800 * 600, 0);  // as dark as lines can be
    detail::Overlay overlay(scene, look, image, masks);
    overlay.paint();
    ASSERT_EQ(overlay.words().size(), 1U);
    const ScreenRect& rect = overlay.words().front().rect;
    const auto x = std::size_t(rect.x + rect.width / 2), y = std::size_t(rect.y + rect.height / 2);
    EXPECT_GT(image.rgba[4 * (800 * y + x)], 150) << "between its words";
    EXPECT_EQ(image.rgba[0], 0) << "nowhere else";
}

// Numbers so long that few have room: two of them, or none.
TEST(Words, NoAxisHasASingleNumber) {
    Scene scene;
    scene.size = 1.0;
    scene.axes = SceneAxes{
        .low = {-0.5, -0.2, -0.1}, .high = {0.5, 0.2, 0.1}, .titles = {"x / mm", "y / mm", "z / mm"}};
    const std::array<double, 3> steps{0.1, 0.1, 0.05};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = static_cast<int>(std::lround(scene.axes->high[Eigen::Index(axis)] / steps[axis]));
        for (int i = -last; i <= last; ++i)
            scene.axes->ticks[axis].push_back({i * steps[axis], std::string("xyz").substr(axis, 1) + " = " +
                                                                    std::to_string(i) + "00 000 000"});
    }
    detail::TextMasks masks;
    std::size_t numbered = 0;
    for (const View& view : views())
        for (const int width : {140, 200, 300, 564}) {
            const PictureSize size{width, width * 5 / 8};
            Image image{size.width, size.height, {}};
            image.rgba.assign(std::size_t(4) * std::size_t(size.width) * std::size_t(size.height), 255);
            detail::OverlayView look;
            look.layers[Layer::axes] = true;
            look.camera = view_of(bounds_of(scene), view.view, size, 50.0, view.perspective);
            detail::Overlay overlay(scene, look, image, masks);
            overlay.paint();
            for (const char* axis : {"x = ", "y = ", "z = "}) {
                const auto numbers = std::ranges::count_if(overlay.words(), [&](const auto& word) {
                    return to_unicode(word.text).starts_with(axis);
                });
                EXPECT_NE(numbers, 1) << axis << "view " << int(view.view) << ", width " << width;
                numbered += numbers > 1;
            }
        }
    EXPECT_GE(numbered, 20U);
}

}  // namespace
}  // namespace covaria::word_overlap_test
