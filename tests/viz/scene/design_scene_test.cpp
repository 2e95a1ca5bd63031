// The scene of a design: candidates, those chosen, the way of the search, regions and boxes; all as data.
#include "viz/scene/design_scene.h"

#include <gtest/gtest.h>

#include "tests/viz/scene_texts.h"
#include "viz/scene/dump_scene.h"

namespace covaria::design_scene_test {
namespace {

LayoutBody instrument(const std::string& name, const Eigen::Vector3d& p_W) {
    LayoutBody body;
    body.name = name;
    body.kind = BodyKind::instrument;
    body.glyph = "tracker";
    body.X_WB.translation() = p_W;
    return body;
}

DesignResult of_rows() {
    DesignResult design;
    design.name = "Two of three";
    design.found = true;
    design.candidates = 4;
    design.rows = {{0, "s0", false, false, 1.6}, {2, "s2", false, false, 0.88}};
    design.gains = {{0, "s0", true, 0.5, Eigen::Vector3d(0, 0, 0)},
                    {1, "s1", false, 0.02, Eigen::Vector3d(1, 0, 0)},
                    {2, "s2", true, 0.1, Eigen::Vector3d(0, 2, 0)},
                    {3, "s3", false, {}, Eigen::Vector3d(0, 0, 3)}};
    design.places.layout.bodies = {instrument("s0", {0, 0, 0}), instrument("s2", {0, 2, 0})};
    return design;
}

DesignResult of_values() {
    DesignResult design;
    design.name = "Place of the tracker";
    design.found = true;
    design.objective = 0.634;
    design.objective_words = "largest U/target";
    design.places.layout.bodies = {instrument("LT", {4, 4, 0})};
    DesignTrack track{"LT", Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 4, 0)};
    track.region = {{-4, -4, 0}, {4, -4, 0}, {-4, 4, 0}, {4, 4, 0}};
    track.path = {{0, 0, 0}, {1, 3, 0}, {1.0001, 3, 0}, {4, 4, 0}};
    track.objectives = {1.0, 0.8, 0.79, 0.634};
    design.places.tracks = {track};
    design.places.obstacles = {{"pillar", {1, 1, 0}, {2, 2, 2}}};
    return design;
}

TEST(DesignScene, CandidatesHaveTheColourOfTheirGainAndThoseChosenAreMarked) {
    const Scene scene = design_scene(of_rows(), {});
    ASSERT_TRUE(scene.map);
    EXPECT_EQ(scene.map->title, "gain / %");
    ASSERT_EQ(scene.map->positions.size(), 4u);
    EXPECT_EQ(scene.map->marked, (std::vector<bool>{true, false, true, false}));
    EXPECT_NEAR(scene.map->values[0], 50.0, 1e-12);
    EXPECT_NEAR(scene.map->low, 2.0, 1e-12);
    EXPECT_NEAR(scene.map->high, 50.0, 1e-12);
    EXPECT_TRUE(scene.map->ways.empty());
    const std::string dump = dump_scene(scene);
    EXPECT_NE(dump.find("with values 3 "), std::string::npos) << "of s3 nothing is known\n" << dump;
    EXPECT_NE(dump.find("marked 2"), std::string::npos);
    EXPECT_NE(dump.find("label \"s1: 2.0 %\""), std::string::npos) << dump;
    EXPECT_NE(dump.find("the larger 2 of 4 are chosen"), std::string::npos);
}

TEST(DesignScene, TheWayOfTheSearchLeadsFromItsPlaceToTheBest) {
    const Scene scene = design_scene(of_values(), {});
    ASSERT_TRUE(scene.map);
    EXPECT_EQ(scene.map->title, "largest U/target");
    ASSERT_EQ(scene.map->positions.size(), 3u) << "places side by side are one";
    EXPECT_EQ(scene.map->ways, (std::vector<std::array<std::size_t, 2>>{{0, 1}, {1, 2}}));
    EXPECT_EQ(scene.map->marked, (std::vector<bool>{false, false, true}));
    EXPECT_NEAR(scene.map->values.back(), 0.634, 1e-12);
    std::size_t region = 0, pillar = 0;
    for (const SceneLink& link : scene.links) {
        region += link.item.id.starts_with("region:LT");
        pillar += link.item.id.starts_with("obstacle:pillar");
    }
    EXPECT_EQ(region, 4u) << "edges of a rectangle";
    EXPECT_EQ(pillar, 12u) << "edges of a box";
    const std::string dump = dump_scene(scene);
    EXPECT_NE(dump.find("label \"best: 0.6340\""), std::string::npos) << dump;
    EXPECT_NE(dump.find("label \"before\""), std::string::npos);
    ASSERT_TRUE(scene.axes);
    EXPECT_LE(scene.axes->low.x(), -4.0) << "the region is within the axes";
}

TEST(DesignScene, IsInTheLanguageThatIsAskedFor) {
    SceneOptions options;
    options.language = test::marking_language();
    DesignResult nowhere = of_rows();
    for (DesignGain& gain : nowhere.gains) gain.place.reset();
    for (const DesignResult& design : {of_rows(), of_values(), nowhere}) {
        const Scene scene = design_scene(design, options);
        EXPECT_FALSE(scene.caption.empty());
        for (const std::string& words : test::words_of(scene)) EXPECT_TRUE(words.starts_with("#")) << words;
        if (scene.map) {
            EXPECT_TRUE(scene.map->title.starts_with("#"));
        }
    }
    const std::string dump = dump_scene(design_scene(of_values(), options));
    EXPECT_NE(dump.find("label \"#best: 0,6340\""), std::string::npos) << dump;
    EXPECT_NE(dump.find("label \"#before\""), std::string::npos) << dump;
}

TEST(DesignScene, SaysWhyThereIsNothingToShow) {
    DesignResult nowhere = of_rows();
    for (DesignGain& gain : nowhere.gains) gain.place.reset();
    EXPECT_EQ(design_scene(nowhere, {}).caption, "nothing that this design chooses stands in space");
    EXPECT_FALSE(design_scene(nowhere, {}).map);
    DesignResult nothing = of_values();
    nothing.found = false;
    EXPECT_EQ(design_scene(nothing, {}).caption, "nothing that was tried has a result");
}

}  // namespace
}  // namespace covaria::design_scene_test
