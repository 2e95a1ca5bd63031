// The scene of a study: colours, places, iso-levels, best and worst point; all as data.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/study/study.h"
#include "tests/viz/scene_texts.h"
#include "viz/scene/dump_scene.h"
#include "viz/scene/study_scene.h"

namespace covaria::study_scene_test {
namespace {

struct Map {
    explicit Map(const std::string& id, const std::vector<StudyOutput>& outputs = {}) {
        Project project = load_project(data_directory() / "projects/lsm-network.covaria").project;
        for (AnalysisEntry& analysis : project.analyses)
            for (Study& study : analysis.studies)
                if (!outputs.empty()) study.outputs = outputs;
        Problems problems;
        prepared = prepare_study(MadeProject::make(project), "recommended", id, problems);
        result = *run_study(*prepared);
    }
    Scene scene(const StudySceneOptions& wanted = {}) const {
        return study_scene(*prepared->analysis, result, wanted, {});
    }
    std::shared_ptr<const PreparedStudy> prepared;
    StudyResult result;
};

std::string line_with(const std::string& text, const std::string& words) {
    const std::size_t at = text.find(words);
    return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

TEST(StudyScene, PointsStandWhereTheTargetIs) {
    const Map map("volume");
    const Scene scene = map.scene();
    ASSERT_TRUE(scene.map);
    ASSERT_EQ(scene.map->positions.size(), 405u);
    EXPECT_NEAR((scene.map->positions.front() - Eigen::Vector3d(1.5, -2.0, -1.2)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((scene.map->positions.back() - Eigen::Vector3d(8.3, 2.0, 0.8)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(scene.map->values.front(), 1e3 * map.result.points.front().places[0].standard_uncertainty(),
                1e-9);
    EXPECT_EQ(scene.map->title, "u(3D), B / mm");
    EXPECT_GE(scene.bodies.size(), 4u) << "the instruments stand around the map";
    const std::string dump = dump_scene(scene);
    EXPECT_TRUE(
        line_with(dump, "map \"").starts_with("map \"u(3D), B / mm\" points 405 with values 405 shown 405 "))
        << dump.substr(0, 2000);
    EXPECT_EQ(line_with(dump, "iso-surfaces of").substr(0, 27), "iso-surfaces of 9 x 9 x 5: ");
}

TEST(StudyScene, NamesBestAndWorst) {
    const Map map("volume");
    const std::string dump = dump_scene(map.scene());
    const StudyExtremes extremes = extremes_of(map.result, study_quantities(map.result)[0]);
    EXPECT_NE(dump.find("label \"best: 0.41"), std::string::npos) << dump.substr(dump.find("label"));
    EXPECT_NE(dump.find("label \"worst: 1.69"), std::string::npos);
    const Scene scene = map.scene();
    EXPECT_EQ(find_item(scene, "map:best")->position, map.result.points[extremes.best].places[0].p_W);
}

// A German window has no "0.41" beside its "0,41", and no English words.
TEST(StudyScene, IsInTheLanguageThatIsAskedFor) {
    const Map map("volume");
    SceneOptions options;
    options.language = test::marking_language();
    options.probability = 0.9545;
    StudySceneOptions wanted;
    wanted.ellipsoids = true;
    const Scene scene = study_scene(*map.prepared->analysis, map.result, wanted, options);
    std::string texts = scene.caption;
    for (const SceneLabel& label : scene.labels) texts += '\n' + to_unicode(label.text);
    for (const LegendLine& line : scene.legend) texts += '\n' + to_unicode(line.text);
    for (const auto& ticks : scene.axes->ticks)
        for (const AxisTick& tick : ticks) texts += '\n' + tick.text;
    for (const AxisTick& tick : scene.map->ticks) texts += '\n' + tick.text;
    EXPECT_NE(texts.find("95,45"), std::string::npos) << texts;
    EXPECT_NE(texts.find("#best: 0,41"), std::string::npos) << texts;
    for (const std::string& words : test::words_of(scene)) EXPECT_TRUE(words.starts_with("#")) << words;
    EXPECT_NE(scene.map->ticks.front().text.find(','), std::string::npos) << texts;
    EXPECT_EQ(texts.find('.'), std::string::npos) << texts;
}

TEST(StudyScene, SliceLeavesOutTheOthers) {
    const Map map("volume");
    const Scene scene = map.scene({.slice_axis = 2, .slice = 3});
    EXPECT_EQ(std::count(scene.map->shown.begin(), scene.map->shown.end(), true), 81);
    EXPECT_EQ(scene.map->low, map.scene().map->low) << "colours are those of the whole study";
}

TEST(StudyScene, EllipsoidsOnRequest) {
    const Map map("volume");
    EXPECT_TRUE(map.scene().ellipsoids.empty());
    const Scene scene = map.scene({.ellipsoids = true});
    EXPECT_EQ(scene.ellipsoids.size(), 405u);
    EXPECT_NE(scene.caption.find("ellipsoids 95"), std::string::npos) << scene.caption;
}

TEST(StudyScene, PointsWithoutValuesAreLeftOut) {
    Map map("volume");
    map.result.points[7] = {.reason = 1};
    map.result.reasons.push_back("behind the camera");
    const Scene scene = map.scene();
    EXPECT_TRUE(std::isnan(scene.map->values[7]));
    EXPECT_NE(dump_scene(scene).find("with values 404"), std::string::npos);
    EXPECT_EQ(scene, map.scene()) << "scenes with gaps compare equal to themselves";
}

TEST(StudyScene, SaysWhyThereIsNoMap) {
    EXPECT_EQ(Map("station-angle").scene().caption, "the point B does not move in this study");
    EXPECT_EQ(Map("volume", {{"distances", "AC"}}).scene().caption,
              "none of the study's output quantities has a place in space");
}

}  // namespace
}  // namespace covaria::study_scene_test
