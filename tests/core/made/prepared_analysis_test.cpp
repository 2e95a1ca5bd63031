// Assets made, edits applied, what depends on what, and a run.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/made.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::prepared_analysis_test {

namespace {

constexpr double micrometre = 1e-6;

// The analysis of the whole project without edits, to be given some.
Project plain_project() {
    Project project = parse(whole_project).project;
    AnalysisEntry& analysis = project.analyses.at(0);
    analysis.inputs.clear();
    analysis.correlations.clear();
    analysis.options = {};
    analysis.options.method = Method::first_order;
    return project;
}

std::shared_ptr<const PreparedAnalysis> prepared(const Project& project) {
    Problems problems;
    auto analysis = made_analysis(project, "sum-1", problems);
    for (const Problem& problem : problems.items())
        ADD_FAILURE() << problem.path << ": " << problem.message.english();
    return analysis;
}

InputEdit with_components(const std::string& symbol, std::vector<ComponentEdit> components) {
    InputEdit edit{symbol};
    edit.components = std::move(components);
    return edit;
}

const ComponentEdit normal_3_um{"certificate", "normal", {0.0, 3.0}, Unit::of("um")};

}  // namespace

TEST(PreparedAnalysis, ModelAsItIsWithoutEdits) {
    const auto analysis = prepared(plain_project());
    ASSERT_TRUE(analysis);
    EXPECT_EQ(analysis->descriptor->id, "sum");
    EXPECT_EQ(analysis->inputs.components.size(), 4u);
    EXPECT_NEAR(standard_uncertainty_of(analysis->inputs, 0), std::sqrt(5.0) * micrometre, 1e-18);
    EXPECT_NE(analysis->assets.find("block-1"), nullptr);
}

TEST(PreparedAnalysis, EstimateIsTheEditedOne) {
    Project project = plain_project();
    InputEdit edit{"a"};
    edit.estimate = Quantity{12.5, Unit::of("mm")};
    edit.components = {{{"drift", "exponential", {3.0}, Unit::of("um")}}};
    project.analyses[0].inputs = {edit};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    EXPECT_NEAR(estimate_of(analysis->inputs, 0), 0.0125, 1e-15);
}

TEST(PreparedAnalysis, ReplacedComponentsKeepThePlacesOfTheOthers) {
    Project project = plain_project();
    project.analyses[0].inputs = {
        with_components("a", {normal_3_um, {"second", "rectangular", {-3.0, 3.0}, Unit::of("um")}})};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    const auto& components = analysis->inputs.components;
    ASSERT_EQ(components.size(), 5u);
    EXPECT_EQ(components[0].id, "temperature");
    EXPECT_EQ(components[1].id, "a.edit1");
    EXPECT_EQ(components[2].id, "b.calibration");
    EXPECT_EQ(components[4].id, "a.edit2");
    EXPECT_NEAR(components[1].distribution.standard_uncertainty(), 3 * micrometre, 1e-18);
    // the shared temperature (1 um) stays: 1 + 9 + 3
    EXPECT_NEAR(standard_uncertainty_of(analysis->inputs, 0), std::sqrt(13.0) * micrometre, 1e-18);
}

TEST(PreparedAnalysis, NoComponentsLeaveOnlyTheSharedOne) {
    Project project = plain_project();
    project.analyses[0].inputs = {with_components("a", {}), with_components("c", {})};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    EXPECT_NEAR(standard_uncertainty_of(analysis->inputs, 0), micrometre, 1e-18);
    EXPECT_EQ(standard_uncertainty_of(analysis->inputs, 2), 0.0);
    EXPECT_EQ(analysis->inputs.components.size(), 4u);
}

TEST(PreparedAnalysis, ParametersWithoutUnitStay) {
    Project project = plain_project();
    project.analyses[0].inputs = {
        with_components("a", {{"log", "lognormal", {-10.0, 0.5}, Unit::of("um")},
                              {"t", "student-t", {0.0, 2.0, 9.0}, Unit::of("um")},
                              {"steps", "discrete", {-1.0, 1.0, 0.5, 0.5}, Unit::of("um")}})};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    const auto& components = analysis->inputs.components;
    EXPECT_EQ(components[1].distribution, Distribution::of(Lognormal{-10.0, 0.5}));
    EXPECT_EQ(components[4].distribution.degrees_of_freedom(), 9.0);
    EXPECT_EQ(components[4].degrees_of_freedom, 9.0);
    EXPECT_NEAR(components[4].distribution.standard_uncertainty(), 2 * micrometre, 1e-18);
    EXPECT_EQ(components[5].distribution, Distribution::of(Discrete{{-micrometre, micrometre}, {0.5, 0.5}}));
}

TEST(PreparedAnalysis, HeldQuantityIsConstantAndOthersStay) {
    Project project = plain_project();
    InputEdit hold{"a"};
    hold.held = true;
    project.analyses[0].inputs = {hold};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    EXPECT_TRUE(analysis->inputs.components[1].held);
    EXPECT_FALSE(analysis->inputs.components[0].held);
    EXPECT_EQ(analysis->inputs.quantities[0].shares.size(), 1u);
    EXPECT_EQ(analysis->inputs.quantities[1].shares.size(), 2u);
    const auto result = run_analysis(*analysis);
    ASSERT_TRUE(result) << result.error().message.english();
    // y = 2 (b + c) + constant: b has 2 and 1 um, c has 2 um
    EXPECT_NEAR(result->outputs[0].standard_uncertainty, 2 * 3.0 * micrometre, 1e-15);
}

TEST(PreparedAnalysis, ComponentIsHeldByItsId) {
    Project project = plain_project();
    InputEdit hold{"temperature"};
    hold.held = true;
    project.analyses[0].inputs = {hold};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    const auto result = run_analysis(*analysis);
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_NEAR(result->outputs[0].standard_uncertainty, 2 * std::sqrt(12.0) * micrometre, 1e-15);
}

TEST(PreparedAnalysis, CorrelationsAndCombination) {
    Project project = plain_project();
    InputEdit sum{"a"};
    sum.combination = Combination::arithmetic;
    project.analyses[0].inputs = {sum};
    project.analyses[0].correlations = {{"b.calibration", "c.calibration", 1.0}};
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    EXPECT_NEAR(standard_uncertainty_of(analysis->inputs, 0), 3 * micrometre, 1e-18);
    ASSERT_EQ(analysis->inputs.correlations.size(), 1u);
    EXPECT_EQ(analysis->inputs.correlations[0].first, 2u);
    EXPECT_EQ(analysis->inputs.correlations[0].second, 3u);
}

// r of the total deviations, however many components they have and however these combine.
TEST(PreparedAnalysis, QuantitiesAreCorrelatedAsAWhole) {
    for (const double r : {-1.0, -0.4, 0.7, 1.0})
        for (const bool arithmetic : {false, true}) {
            Project project = plain_project();
            const auto component = [](const char* name, double u) {
                return ComponentEdit{name, "normal", {0.0, u}, Unit::of("um")};
            };
            InputEdit b = with_components("b", {component("one", 3.0), component("two", 4.0)});
            if (arithmetic) b.combination = Combination::arithmetic;
            project.analyses[0].inputs = {
                b, with_components("c",
                                   {component("one", 2.0), component("two", 1.0), component("three", 1.0)})};
            project.analyses[0].correlations = {{"b", "c", r}};
            const auto analysis = prepared(project);
            ASSERT_TRUE(analysis);
            InputSet inputs = analysis->inputs;
            InputQuantity sum{.symbol = "sum"};
            double u[2];
            for (std::size_t k = 0; k < 2; ++k) {
                const std::size_t index = inputs.find(k == 0 ? "b" : "c");
                u[k] = standard_uncertainty_of(inputs, index);
                for (const Share& share : inputs.quantities[index].shares) sum.shares.push_back(share);
            }
            inputs.quantities.push_back(sum);
            EXPECT_NEAR(standard_uncertainty_of(inputs, inputs.quantities.size() - 1),
                        std::sqrt(u[0] * u[0] + u[1] * u[1] + 2.0 * r * u[0] * u[1]), 1e-6 * u[0])
                << r << " " << arithmetic;
        }
}

TEST(PreparedAnalysis, RunHasItsProvenance) {
    Project project = plain_project();
    project.analyses[0].options.method = Method::monte_carlo;
    project.analyses[0].options.trials = 1000;
    project.analyses[0].options.seed = 42;
    const auto analysis = prepared(project);
    ASSERT_TRUE(analysis);
    const auto result = run_analysis(*analysis);
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_EQ(result->trials, 1000u);
    EXPECT_EQ(result->provenance.seed, 42u);
    EXPECT_EQ(result->provenance.project_fingerprint, analysis->fingerprint());
    EXPECT_FALSE(result->provenance.covaria_version.empty());
}

TEST(PreparedAnalysis, WarningsAreThoseOfTheAssetsThatAreUsedAndOfTheAnalysis) {
    Project project = plain_project();
    project.assets[0].setup.values["rounds"] = Quantity{1.0};
    AssetEntry unused = project.assets[0];
    unused.id = "unused";
    project.assets.insert(project.assets.begin(), unused);
    for (const char* symbol : {"a", "b", "c"})
        project.analyses[0].inputs.push_back({.symbol = symbol, .held = true});
    const auto made = MadeProject::make(project);
    const std::vector<Message> warnings = made->warnings_of("sum-1");
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0], "asset 'the block': one round does not say how well it repeats");
    EXPECT_TRUE(warnings[1].english().starts_with("no input quantity has an uncertainty")) << warnings[1];
    EXPECT_TRUE(made->warnings_of("nothing").empty());
}

TEST(PreparedAnalysis, FingerprintFollowsTheAssetsThatAreUsed) {
    Project project = plain_project();
    AssetEntry unused = project.assets[0];
    unused.id = "unused";
    project.assets.push_back(unused);
    const std::string before = prepared(project)->fingerprint();
    Project other = project;
    other.assets[2].setup.values["rounds"] = Quantity{7.0};
    EXPECT_EQ(prepared(other)->fingerprint(), before);
    other.assets[0].setup.values["rounds"] = Quantity{7.0};
    EXPECT_NE(prepared(other)->fingerprint(), before);
}

TEST(PreparedAnalysis, WhatUsesWhat) {
    Project project = plain_project();
    project.analyses[0].setup.values.erase("clamp");
    AnalysisEntry second = project.analyses[0];
    second.id = "sum-2";
    second.setup.values["clamp"] = std::string("clamp_2");
    project.analyses.push_back(second);
    EXPECT_EQ(assets_used_by(project, project.analyses[0]), std::vector<std::string>{"block-1"});
    EXPECT_EQ(assets_used_by(project, project.analyses[1]), (std::vector<std::string>{"block-1", "clamp_2"}));
    EXPECT_EQ(analyses_using(project, "block-1"), (std::vector<std::string>{"sum-1", "sum-2"}));
    EXPECT_EQ(analyses_using(project, "clamp_2"), std::vector<std::string>{"sum-2"});
    EXPECT_TRUE(analyses_using(project, "none").empty());
}

TEST(PreparedAnalysis, UsedThroughAnotherAsset) {
    Project project = plain_project();
    AssetEntry inner = project.assets[0];
    inner.id = "inner";
    project.assets.push_back(inner);
    project.assets[1].setup.values["block"] = std::string("inner");
    EXPECT_EQ(analyses_using(project, "inner"), std::vector<std::string>{"sum-1"});
}

TEST(PreparedAnalysis, AssetsWithErrorsAreNamedByTheirUsers) {
    Project project = plain_project();
    project.assets[0].setup.values.erase("length");
    Problems problems;
    const AssetLibrary assets = made_assets(project, problems);
    EXPECT_EQ(assets.find("block-1"), nullptr);
    EXPECT_EQ(problem_with(problems, "'length of the block' must be given").path, "/assets/0/setup/length");
    EXPECT_EQ(problem_with(problems, "which has errors of its own").path, "/assets/1/setup/block");
    const auto made = MadeProject::make(project);
    EXPECT_EQ(made->analysis("sum-1"), nullptr);
    EXPECT_EQ(problem_with(made->problems_of_analysis("sum-1"), "which has errors of its own").path,
              "/analyses/0/setup/block");
}

TEST(PreparedAnalysis, UnknownAnalysis) {
    Problems problems;
    EXPECT_EQ(made_analysis(plain_project(), "sum1", problems), nullptr);
    EXPECT_EQ(problem_with(problems, "there is no analysis 'sum1' (did you mean 'sum-1'?)").severity,
              Severity::error);
}

}  // namespace covaria::test::prepared_analysis_test
