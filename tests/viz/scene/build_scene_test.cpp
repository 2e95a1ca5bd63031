// Scenes of a known layout: what is in them, at which magnification, and what is left out.
#include "viz/scene/build_scene.h"
#include "tests/core/result/changed_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>

#include "tests/viz/scene_texts.h"
#include "tests/viz/stewart_scene.h"
#include "viz/scene/dump_scene.h"
#include "viz/scene/visibility.h"

namespace covaria::build_scene_test {
namespace {

const SceneEllipsoid* ellipsoid_of(const Scene& scene, const std::string& id) {
    for (const SceneEllipsoid& e : scene.ellipsoids)
        if (e.item.id == id) return &e;
    return nullptr;
}

bool legend_says(const Scene& scene, const std::string& words) {
    return std::ranges::any_of(scene.legend, [&](const LegendLine& line) {
        return to_unicode(line.text).find(words) != std::string::npos;
    });
}

bool legend_has(const Scene& scene, LegendMark mark, Role role) {
    return std::ranges::any_of(
        scene.legend, [&](const LegendLine& line) { return line.mark == mark && line.role == role; });
}

TEST(BuildScene, TextOfTheStewartPlatformIsTheReviewedOne) {
    const auto setup = test::stewart_setup(400);
    const std::string text = dump_scene(build_scene(setup.source(), {}));
    const std::string file = COVARIA_SOURCE_DIR "/tests/viz/baselines/stewart_scene.txt";
    std::ifstream in(file);
    std::ostringstream expected;
    expected << in.rdbuf();
    if (text != expected.str()) std::ofstream(COVARIA_BINARY_DIR "/stewart_scene.txt") << text;
    EXPECT_EQ(text, expected.str()) << "new text in " COVARIA_BINARY_DIR "/stewart_scene.txt";
}

TEST(BuildScene, TakesTheGroupAndWhatBelongsToAll) {
    const auto setup = test::stewart_setup(0);
    SceneOptions options;
    options.group = "pose 4";
    const Scene scene = build_scene(setup.source(), options);
    EXPECT_EQ(scene.group, "pose 4");
    EXPECT_NE(find_item(scene, "point:b1"), nullptr);
    EXPECT_NE(find_item(scene, "point:elsewhere"), nullptr);
    EXPECT_EQ(find_item(scene, "point:p1"), nullptr);
    EXPECT_EQ(build_scene(setup.source(), {}).group, "pose 3") << "the first group of the result";
}

// Items that do not meet their requirement are marked, as in the tree, and others are not.
TEST(BuildScene, WhatIsNotMetIsMarked) {
    const auto setup = test::stewart_setup(0);
    const auto marked = [&](std::size_t output, bool met) {
        SceneOptions options;
        options.verdicts.emplace_back();
        options.verdicts.back().output = output;
        options.verdicts.back().meets_target = met;
        return build_scene(setup.source(), options);
    };
    const Scene scene = marked(0, false);
    ASSERT_EQ(scene.not_met.size(), 1u);
    EXPECT_EQ(scene.not_met.front().item, "point:platform origin");
    EXPECT_EQ(scene.not_met.front().at, find_item(scene, "point:platform origin")->position);
    EXPECT_TRUE(legend_says(scene, "not met"));
    EXPECT_TRUE(marked(99, false).not_met.empty()) << "there is none";
    EXPECT_TRUE(marked(0, true).not_met.empty());
    EXPECT_FALSE(legend_says(marked(0, true), "not met"));
    const Scene hidden = visible_part(scene, {{"point:platform origin"}, {}});
    EXPECT_TRUE(hidden.not_met.empty());
    EXPECT_FALSE(legend_says(hidden, "not met"));
}

TEST(BuildScene, EllipsoidHoldsTheProbability) {
    const auto setup = test::stewart_setup(0);
    SceneOptions options;
    options.magnification = 1.0;
    const Scene scene = build_scene(setup.source(), options);
    const SceneEllipsoid* nest = ellipsoid_of(scene, "point:p1");
    ASSERT_NE(nest, nullptr);
    const double k =
        2.7954834829151074;  // square root of the 0.95 quantile of chi-squared, 3 dof (7.8147279)
    EXPECT_NEAR(nest->coverage_factor, k, 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(nest->axes.col(i).norm(), k * 236e-6, 1e-12);
    EXPECT_EQ(nest->role, Role::input);
    EXPECT_EQ(ellipsoid_of(scene, "point:platform origin")->role, Role::output);
}

// Twice the uncertainty before: ellipsoids of both about the same points, at one magnification, which leaves
// room for the larger ones.
TEST(BuildScene, EllipsoidsOfWhatIsComparedStandAboutTheSamePoints) {
    const auto now = test::stewart_setup(0), was = test::stewart_setup(0, 2.0);
    auto before = std::make_shared<UncertaintyResult>(was.result);
    std::reverse(before->outputs.begin(), before->outputs.end());  // others stand elsewhere there
    before->covariance = Eigen::MatrixXd(was.result.covariance.whole().reverse());
    const ResultComparison compared =
        compare_results(before, std::make_shared<UncertaintyResult>(now.result));
    SceneSource source = now.source();
    source.compared = &compared;
    const Scene scene = build_scene(source, {});
    const Scene larger = build_scene(was.source(), {});
    ASSERT_FALSE(scene.ellipsoids.empty());
    ASSERT_EQ(scene.ellipsoids_before.size(), scene.ellipsoids.size());
    for (std::size_t i = 0; i < scene.ellipsoids.size(); ++i) {
        EXPECT_EQ(scene.ellipsoids_before[i].item, scene.ellipsoids[i].item);
        EXPECT_EQ(scene.ellipsoids_before[i].role, Role::before);
        EXPECT_NEAR(scene.ellipsoids_before[i].axes.col(0).norm(),
                    2.0 * scene.ellipsoids[i].axes.col(0).norm(), 1e-9);
    }
    EXPECT_EQ(scene.magnification, larger.magnification);
    EXPECT_EQ(scene.legend.size(), build_scene(now.source(), {}).legend.size() + 1);
    const Visibility without{.hidden = {"point:p1"}};
    EXPECT_EQ(visible_part(scene, without).ellipsoids_before.size(), scene.ellipsoids_before.size() - 1);
}

TEST(BuildScene, AQuantityThatWasNotThereHasNoEllipsoidBefore) {
    const auto now = test::stewart_setup(0);
    auto before = std::make_shared<UncertaintyResult>(now.result);
    test::change_inputs(*before, [](InputSet& inputs) { inputs.quantities[9].symbol = "other"; });  // p1x
    const ResultComparison compared =
        compare_results(before, std::make_shared<UncertaintyResult>(now.result));
    SceneSource source = now.source();
    source.compared = &compared;
    const Scene scene = build_scene(source, {});
    EXPECT_EQ(scene.ellipsoids_before.size() + 1, scene.ellipsoids.size());
    for (const SceneEllipsoid& e : scene.ellipsoids_before) EXPECT_NE(e.item.id, "point:p1");
}

TEST(BuildScene, EllipsoidIsTurnedWithTheAxesOfItsQuantities) {
    auto setup = test::stewart_setup(0);
    Eigen::Matrix3d R;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    setup.layout.points[0].R_WQ = R;  // b1: its y (u = 0.110 mm, the longest) now lies along -x of W
    const Scene scene = build_scene(setup.source(), {});
    const SceneEllipsoid* b1 = ellipsoid_of(scene, "point:b1");
    ASSERT_NE(b1, nullptr);
    EXPECT_NEAR(std::abs(b1->axes.col(0).normalized().x()), 1.0, 1e-12);
    EXPECT_NEAR((*b1->item.u)[1], 110e-6, 1e-15) << "u stays along the axes of the quantities";
}

TEST(BuildScene, ComponentSharedByTwoCoordinatesTiltsTheEllipsoid) {
    auto setup = test::stewart_setup(0);
    test::change_inputs(setup.result, [](InputSet& inputs) {
        inputs.quantities[0].shares = {{0, 1.0}};
        inputs.quantities[1].shares = {{0, 1.0}};  // y moves with x
    });
    const Scene scene = build_scene(setup.source(), {});
    const SceneEllipsoid* b1 = ellipsoid_of(scene, "point:b1");
    ASSERT_NE(b1, nullptr);
    EXPECT_EQ(b1->rank, 2);
    const double k = 2.447746830680816;  // square root of the 0.95 quantile of chi-squared, 2 dof (5.9914645)
    EXPECT_NEAR(b1->coverage_factor, k, 1e-9);
    EXPECT_NEAR(b1->axes.col(2).norm(), 0.0, 0.0);
    const Eigen::Vector3d diagonal = k * 66e-6 * scene.magnification * Eigen::Vector3d(1, 1, 0);
    const double nearest = std::min((b1->axes.col(0) - diagonal).norm(), (b1->axes.col(1) - diagonal).norm());
    EXPECT_NEAR(nearest, 0.0, 1e-12);
}

TEST(BuildScene, ArithmeticComponentsAddLinearly) {
    auto setup = test::stewart_setup(0);
    test::change_inputs(setup.result, [](InputSet& inputs) {
        InputQuantity& x = inputs.quantities[0];
        x.shares = {{0, 1.0}, {1, 1.0}};
        x.combination = Combination::arithmetic;
        inputs.quantities[1].shares.clear();
    });
    const Scene scene = build_scene(setup.source(), {});
    EXPECT_NEAR(find_item(scene, "point:b1")->u->x(), 66e-6 + 110e-6, 1e-15);
}

TEST(BuildScene, HeldComponentsContributeNothing) {
    auto setup = test::stewart_setup(0);
    test::change_inputs(setup.result, [](InputSet& inputs) {
        for (UncertaintyComponent& component : inputs.components) component.held = true;
    });
    const Scene scene = build_scene(setup.source(), {});
    EXPECT_EQ(scene.ellipsoids.size(), 1u) << "only that of the output is left";
}

class AutomaticMagnification : public testing::TestWithParam<double> {};

// The largest ellipsoid of the outputs covers about a twentieth of a picture of the whole, twice as wide as
// high.
TEST_P(AutomaticMagnification, IsShortToWriteAndShowsTheLargestEllipsoidOnATwentieth) {
    const auto setup = test::stewart_setup(0, GetParam());
    const Scene scene = build_scene(setup.source(), {});
    const double decade = std::pow(10.0, std::floor(std::log10(scene.magnification) + 1e-9));
    const double digits = 10.0 * scene.magnification / decade;
    EXPECT_NEAR(digits, std::round(digits), 1e-6);
    const SceneEllipsoid* largest = ellipsoid_of(scene, "point:platform origin");
    ASSERT_NE(largest, nullptr);
    const double area = std::numbers::pi * largest->axes.col(0).norm() * largest->axes.col(1).norm();
    const double picture = 0.72 * scene.size * scene.size;
    EXPECT_GT(area, 0.05 / 1.6 * picture);
    EXPECT_LT(area, 0.05 * 1.6 * picture);
}
INSTANTIATE_TEST_SUITE_P(Scales, AutomaticMagnification,
                         testing::Values(1e-6, 0.03, 0.7, 1.0, 2.0, 4.0, 9.0, 3e3));

// Neighbours so near that they leave no room outside of the balls.
TEST(BuildScene, SomeEllipsoidIsSeenHoweverNearTheNextPointIs) {
    auto setup = test::stewart_setup(0);
    const double size = build_scene(setup.source(), {}).size;
    for (const double apart : {0.011, 0.02, 0.05, 0.2}) {
        for (std::size_t i = 1; i < setup.layout.points.size(); ++i)
            setup.layout.points[i].p_W = Eigen::Vector3d(double(i % 3), double(i / 3), 0.0) * apart * size;
        const Scene scene = build_scene(setup.source(), {});
        std::size_t seen = 0;
        for (const SceneEllipsoid& e : scene.ellipsoids)
            for (const ScenePoint& point : scene.points)
                seen += point.item.id == e.item.id && e.axes.col(0).norm() > point.radius;
        EXPECT_GT(seen, 0u) << apart;
        EXPECT_TRUE(legend_has(scene, LegendMark::ellipsoid, Role::output) ||
                    legend_has(scene, LegendMark::ellipsoid, Role::input))
            << apart;
    }
}

TEST(BuildScene, CaptionSaysMagnificationAndProbability) {
    const auto setup = test::stewart_setup(100);
    SceneOptions options;
    options.magnification = 2000;
    EXPECT_EQ(build_scene(setup.source(), options).caption, "ellipsoids 95\u00a0%, ×\u00a02000");
    options.probability = 0.9973;
    options.magnification = 25000;
    EXPECT_EQ(build_scene(setup.source(), options).caption,
              "ellipsoids 99.73\u00a0%, ×\u00a025\u202f"
              "000");
    options.ellipsoids = false;
    EXPECT_EQ(build_scene(setup.source(), options).caption,
              "uncertainty ×\u00a025\u202f"
              "000");
    options.clouds = false;
    EXPECT_EQ(build_scene(setup.source(), options).caption, "");
}

// A reduction is written as a scale; its factor had all zeros: "× 0.0000002".
TEST(BuildScene, AReductionIsAScale) {
    const auto setup = test::stewart_setup(0);
    SceneOptions options;
    for (const auto& [magnification, words] : {std::pair{1.0, "×\u00a01"},
                                               {0.5, "×\u00a00.5"},
                                               {0.05, "1\u00a0:\u00a020"},
                                               {2e-7, "1\u00a0:\u00a05\u202f000\u202f000"},
                                               {2e-12, "1\u00a0:\u00a05×10¹¹"},
                                               {2e12, "×\u00a02×10¹²"}}) {
        options.magnification = magnification;
        EXPECT_EQ(build_scene(setup.source(), options).caption,
                  std::string("ellipsoids 95\u00a0%, ") + words);
    }
}

// The ten with the largest U are named, one that does not meet its requirement always, the others when asked.
TEST(BuildScene, LabelsOfTheWorstPointsAreWritten) {
    auto setup = test::stewart_setup(0);
    const Scene scene = build_scene(setup.source(), {});
    const auto label = [](const Scene& in, const std::string& item) {
        const auto found = std::ranges::find(in.labels, item, &SceneLabel::item);
        return found == in.labels.end() ? SceneLabel{} : *found;
    };
    EXPECT_FALSE(label(scene, "point:platform origin").when_asked);
    EXPECT_EQ(to_unicode(label(scene, "point:platform origin").fact), "U: 0.73, 0.63, 0.30\u00a0mm");
    EXPECT_TRUE(label(scene, "point:b1").when_asked) << "an input";
    EXPECT_TRUE(label(scene, "frame:base b").when_asked);
    SceneSource layout_only = setup.source();
    layout_only.result = nullptr;
    EXPECT_FALSE(label(build_scene(layout_only, {}), "point:b1").when_asked) << "there are no outputs";
    for (int i = 0; i < 20; ++i)
        setup.layout.points.push_back({.name = "t" + std::to_string(i), .p_W = {0.1 * i, 0, 0}});
    layout_only.layout = &setup.layout;
    const Scene many = build_scene(layout_only, {});
    EXPECT_EQ(std::ranges::count(many.labels, false, &SceneLabel::when_asked), 10);
}

// Many points near each other, seen by an instrument far away.
TEST(BuildScene, AClusterOfOutputsIsWhatThePictureIsAbout) {
    auto setup = test::stewart_setup(0);
    EXPECT_FALSE(build_scene(setup.source(), {}).focus) << "they are all over it";
    for (std::size_t i = 0; i < 4; ++i)
        setup.layout.points.push_back({.name = "t" + std::to_string(i),
                                       .p_W = {0.05 * double(i), 0.1 * double(i % 2), 1.2},
                                       .group = "pose 3",
                                       .outputs = {{0, 1, 2}}});
    LayoutBody tracker{.name = "tracker", .kind = BodyKind::instrument, .glyph = "tracker"};
    tracker.X_WB.translation().x() = 12.0;
    setup.layout.bodies.push_back(tracker);
    const Scene scene = build_scene(setup.source(), {});
    ASSERT_TRUE(scene.focus);
    EXPECT_LT((scene.focus->high - scene.focus->low).norm(), 0.2 * scene.size);
    for (const SceneEllipsoid& ellipsoid : scene.ellipsoids)
        if (ellipsoid.role == Role::output) {
            EXPECT_TRUE((ellipsoid.item.position.array() >= scene.focus->low.array()).all());
            EXPECT_TRUE((ellipsoid.item.position.array() <= scene.focus->high.array()).all());
        }
}

TEST(BuildScene, IsInTheLanguageThatIsAskedFor) {
    auto setup = test::stewart_setup(400);
    setup.layout.vectors = {{.name = "F", .vector_W = {0.0, 0.0, 50.0}},
                            {.name = "M", .vector_W = {0.2, 0.0, 0.0}, .kind = VectorKind::moment}};
    SceneOptions options;
    options.language = test::marking_language();
    options.probability = 0.9545;
    const std::vector<std::string> texts = test::words_of(build_scene(setup.source(), options));
    EXPECT_GE(texts.size(), 8u) << "caption, ellipsoids and clouds of both roles, histograms, arrows";
    for (const std::string& words : texts) EXPECT_TRUE(words.starts_with("#")) << words;
    EXPECT_NE(test::joined(texts).find("95,45"), std::string::npos);
}

TEST(BuildScene, CloudIsMagnifiedAboutTheEstimate) {
    auto setup = test::stewart_setup(5);
    setup.output_trials.col(1) << 1e-3, -2e-3, 1.175 + 3e-3;
    setup.output_trials(0, 3) = std::nan("");
    SceneOptions options;
    options.magnification = 100;
    const Scene scene = build_scene(setup.source(), options);
    const SceneCloud& cloud = scene.clouds.back();
    EXPECT_EQ(cloud.item.id, "point:platform origin");
    EXPECT_EQ(cloud.size(), 4u) << "the trial without a value is left out";
    EXPECT_NEAR(cloud.offsets[3], 0.1f, 1e-6f);
    EXPECT_NEAR(cloud.offsets[4], -0.2f, 1e-6f);
    EXPECT_NEAR(cloud.offsets[5], 0.3f, 1e-6f);
}

TEST(BuildScene, CloudsAreThinnedToTheLimit) {
    const auto setup = test::stewart_setup(1000);
    SceneOptions options;
    options.cloud_limit = 300;
    for (const SceneCloud& cloud : build_scene(setup.source(), options).clouds) EXPECT_EQ(cloud.size(), 300u);
}

TEST(BuildScene, WallHistogramsCountTheCloud) {
    const auto setup = test::stewart_setup(5000);
    const Scene scene = build_scene(setup.source(), {});
    ASSERT_EQ(scene.wall_histograms.size(), 3u);
    for (const SceneWallHistogram& h : scene.wall_histograms) {
        EXPECT_EQ(h.cloud, "point:platform origin");
        EXPECT_EQ(*std::max_element(h.bars.begin(), h.bars.end()), 1.0);
        EXPECT_GT(h.bars[h.bars.size() / 2], 0.7) << "most trials are near the estimate";
        EXPECT_LT(h.bars.front(), 0.1);
        EXPECT_NE(h.axis, h.normal);
        EXPECT_NE(h.axis, h.height);
    }
    SceneOptions options;
    options.histograms_of = "p2";
    EXPECT_EQ(build_scene(setup.source(), options).wall_histograms.front().cloud, "point:p2");
}

TEST(BuildScene, NoUncertaintyNoResultNoLayout) {
    const auto exact = test::stewart_setup(200, 0.0);
    const Scene without = build_scene(exact.source(), {});
    EXPECT_TRUE(without.ellipsoids.empty());
    EXPECT_TRUE(without.clouds.empty());
    EXPECT_TRUE(without.caption.empty());
    EXPECT_EQ(without.points.size(), 7u);

    SceneSource layout_only = exact.source();
    layout_only.result = nullptr;
    EXPECT_EQ(build_scene(layout_only, {}).group, "pose 3");
    EXPECT_FALSE(find_item(build_scene(layout_only, {}), "point:b1")->u.has_value());

    EXPECT_EQ(build_scene({}, {}).size, 0.0);
    const Layout nothing;
    EXPECT_FALSE(build_scene({&nothing, nullptr, nullptr, nullptr, ""}, {}).axes.has_value());
}

TEST(BuildScene, LengthsAreInInchesForWhoeverPrefersOneOfTheirs) {
    const auto setup = test::stewart_setup(0);
    SceneOptions options;
    for (const char* metric : {"m", "um"}) {
        options.units.choose(Unit::of(metric));
        EXPECT_EQ(build_scene(setup.source(), options).unit.text, "mm") << "by the size of what is drawn";
    }
    options.units.choose(Unit::of("thou"));
    const Scene scene = build_scene(setup.source(), options);
    EXPECT_EQ(scene.unit, (LengthUnit{"in", 1.0 / 0.0254}));
    EXPECT_EQ(scene.axes->titles[0], "x / in");
    ASSERT_GT(scene.axes->ticks[0].size(), 1u);
    for (const AxisTick& tick : scene.axes->ticks[0])
        EXPECT_NEAR(tick.at / 0.0254, std::round(tick.at / 0.0254 * 100.0) / 100.0, 1e-9) << "round inches";
}

// Inputs so exact that their ellipsoids and clouds are inside the balls of their points.
TEST(BuildScene, LegendListsTheUncertaintyThatIsSeen) {
    auto setup = test::stewart_setup(200);
    EXPECT_TRUE(legend_has(build_scene(setup.source(), {}), LegendMark::ellipsoid, Role::input));
    test::change_inputs(setup.result, [](InputSet& inputs) {
        for (InputQuantity& quantity : inputs.quantities)
            for (auto& share : quantity.shares) share.factor *= 0.01;
    });
    for (Eigen::Index i = 0; i < setup.input_trials.rows(); ++i) {
        const double estimate = estimate_of(setup.result.inputs, std::size_t(i));
        setup.input_trials.row(i).array() = estimate + 0.01 * (setup.input_trials.row(i).array() - estimate);
    }
    const Scene scene = build_scene(setup.source(), {});
    EXPECT_EQ(scene.ellipsoids.size(), 7u) << "they are there, for who comes nearer";
    EXPECT_FALSE(legend_has(scene, LegendMark::ellipsoid, Role::input));
    EXPECT_FALSE(legend_has(scene, LegendMark::cloud, Role::input));
    EXPECT_TRUE(legend_says(scene, "in: uncertainty too small to be seen"));
    EXPECT_TRUE(legend_has(scene, LegendMark::ellipsoid, Role::output));
    EXPECT_TRUE(legend_has(scene, LegendMark::cloud, Role::output));
    const Visibility without{
        .hidden = {"point:b1", "point:b2", "point:b3", "point:p1", "point:p2", "point:p3"}};
    EXPECT_FALSE(legend_says(visible_part(scene, without), "too small"));
}

TEST(BuildScene, SaysWhereOnlySomePointsShowTheirUncertainty) {
    auto setup = test::stewart_setup(0);
    setup.layout.uncertain_points = 7;
    EXPECT_TRUE(build_scene(setup.source(), {}).notes.empty()) << "all of them";
    setup.layout.uncertain_points = 60;
    const std::vector<std::string> expected{"uncertainty drawn at 7 of 60 points"};
    EXPECT_EQ(build_scene(setup.source(), {}).notes, expected);
    SceneSource layout_only = setup.source();
    layout_only.result = nullptr;
    EXPECT_TRUE(build_scene(layout_only, {}).notes.empty()) << "none is drawn at all";
}

// Flat layouts of many shapes, anywhere.
TEST(BuildScene, EveryAxisHasTwoNumbers) {
    for (const double from : {-3.1, -0.47, 0.0, 0.26, 12.3})
        for (double high = 0.02; high < 1.0; high *= 1.07) {
            Layout layout;
            layout.points = {{.name = "a", .p_W = {0.0, from, 0.0}},
                             {.name = "b", .p_W = {2.0, from + high, high / 2}}};
            const Scene scene = build_scene({.layout = &layout}, {});
            ASSERT_TRUE(scene.axes);
            for (const auto& ticks : scene.axes->ticks) EXPECT_GE(ticks.size(), 2u) << from << " " << high;
        }
}

TEST(BuildScene, IndicesOutOfRangeAndInfiniteUncertaintyAreLeftOut) {
    auto setup = test::stewart_setup(0);
    setup.layout.points[0].inputs = {{0, 1, 999}};
    setup.result.covariance.whole()(0, 0) = std::numeric_limits<double>::infinity();
    const Scene scene = build_scene(setup.source(), {});
    EXPECT_EQ(ellipsoid_of(scene, "point:b1"), nullptr);
    EXPECT_EQ(ellipsoid_of(scene, "point:platform origin"), nullptr);
    EXPECT_EQ(scene.ellipsoids.size(), 5u);
}

TEST(BuildScene, VectorsHaveTheirUncertaintyAtTheTip) {
    auto setup = test::stewart_setup(400);
    const LayoutPoint origin = *std::find_if(setup.layout.points.begin(), setup.layout.points.end(),
                                             [](const LayoutPoint& p) { return p.outputs.has_value(); });
    const Eigen::Vector3d at(0.1, 0.2, 0.3);
    LayoutVector force{.name = "F", .at_W = at, .vector_W = {0.0, 0.0, 50.0}, .outputs = origin.outputs};
    LayoutVector small{.name = "G", .at_W = at, .vector_W = {10.0, 0.0, 0.0}};
    LayoutVector moment{.name = "M", .at_W = at, .vector_W = {0.2, 0.0, 0.0}, .kind = VectorKind::moment};
    setup.layout.vectors = {force, small, moment};
    SceneOptions options;
    options.magnification = 1.0;
    const Scene scene = build_scene(setup.source(), options);
    ASSERT_EQ(scene.vectors.size(), 3u);
    const double length = scene.vectors[0].arrow.norm();
    EXPECT_NEAR(scene.vectors[1].arrow.norm(), length / 5.0, 1e-12) << "forces share a scale";
    EXPECT_NEAR(scene.vectors[2].arrow.norm(), length, 1e-12) << "moments have their own";
    const SceneEllipsoid* tip = ellipsoid_of(scene, "vector:F");
    const SceneEllipsoid* point = ellipsoid_of(scene, "point:" + origin.name);
    ASSERT_TRUE(tip && point);
    EXPECT_LT((tip->item.position - at - scene.vectors[0].arrow).norm(), 1e-12);
    EXPECT_NEAR(tip->axes.col(0).norm(), point->axes.col(0).norm() * length / 50.0, 1e-12)
        << "drawn to the scale of the arrow";
    EXPECT_EQ(ellipsoid_of(scene, "vector:G"), nullptr);
    const auto cloud = std::find_if(scene.clouds.begin(), scene.clouds.end(),
                                    [](const SceneCloud& c) { return c.item.id == "vector:F"; });
    ASSERT_NE(cloud, scene.clouds.end());
    EXPECT_GT(cloud->size(), 100u);
    const auto legend = [&](const std::string& text) {
        return std::any_of(scene.legend.begin(), scene.legend.end(),
                           [&](const LegendLine& line) { return to_unicode(line.text).starts_with(text); });
    };
    EXPECT_TRUE(legend("force") && legend("moment"));
}

TEST(BuildScene, EqualNamesGetDifferentIds) {
    Layout layout;
    layout.points = {{"T", PointKind::target, {0, 0, 0}}, {"T", PointKind::target, {1, 0, 0}}};
    const Scene scene = build_scene({&layout, nullptr, nullptr, nullptr, ""}, {});
    EXPECT_NE(find_item(scene, "point:T"), nullptr);
    EXPECT_NE(find_item(scene, "point:T#2"), nullptr);
}

TEST(BuildScene, PlateHasRoundCornersAroundItsPoints) {
    const auto setup = test::stewart_setup(0);
    const Scene scene = build_scene(setup.source(), {});
    const SceneBody& plate = scene.bodies.front();
    double farthest = 0.0;
    for (const Eigen::Vector3d& corner : plate.outline)
        farthest = std::max(farthest, corner.head<2>().norm());
    const double radius_of_points = Eigen::Vector2d(0.344, 0.196).norm();
    EXPECT_GT(farthest, radius_of_points);
    EXPECT_LT(farthest, radius_of_points + 0.06);
    EXPECT_TRUE(plate.normal.isApprox(Eigen::Vector3d::UnitZ()));
}

}  // namespace
}  // namespace covaria::build_scene_test
