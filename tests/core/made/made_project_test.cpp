// The entries that an edit makes anew, counted; problems that keep their place; circles.
#include "core/made/made_project.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::made_project_test {
namespace {

/// block-1 <- clamp_2 <- sum-1 (which uses both), sum-2 (of block-3 alone).
Project start() {
    Project project = parse(whole_project).project;
    AssetEntry other = project.assets[0];
    other.id = "block-3";
    project.assets.push_back(other);
    AnalysisEntry& first = project.analyses.at(0);
    first.options = {};
    first.options.method = Method::first_order;
    first.requirements.clear();
    first.studies.clear();
    AnalysisEntry second = first;
    second.id = "sum-2";
    second.setup.values["block"] = std::string("block-3");
    second.setup.values.erase("clamp");
    project.analyses.push_back(second);
    return project;
}

void expect_none(const Problems& problems) {
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
}

struct Edited : testing::Test {
    Project project = start();
    MadeProject::Pointer before = MadeProject::make(project), now;

    /// Applies a change; returns how much was made anew.
    MakingCounts edit(const std::function<void(Project&)>& change) {
        change(project);
        now = MadeProject::make(project, before);
        expect_none(now->problems());
        return now->counts();
    }
    bool has_same(const std::string& analysis) const {
        return now->analysis(analysis) == before->analysis(analysis);
    }
    bool shares_law(const std::string& analysis) const {
        return &now->analysis(analysis)->propagated->propagation() ==
               &before->analysis(analysis)->propagated->propagation();
    }
};

TEST_F(Edited, TheFirstStateIsMadeWhole) {
    expect_none(before->problems());
    expect_counts(before->counts(), {.assets = 3, .models = 2, .inputs = 2, .taken = 0});
    EXPECT_EQ(before->assets().entries().size(), 3u);
    EXPECT_EQ(before->analysis("sum-1")->assets.entries().size(), 2u);
    EXPECT_EQ(before->assets_used_by("sum-1"), (std::vector<std::string>{"block-1", "clamp_2"}));
    EXPECT_EQ(before->analysis("nothing"), nullptr);
    EXPECT_EQ(before->find_analysis("nothing"), nullptr);
}

TEST_F(Edited, ATitleAndNotesMakeNothing) {
    expect_counts(edit([](Project& p) {
                      p.title = "another";
                      p.notes = p.analyses[0].notes = p.assets[0].notes = "some";
                  }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 5});
    EXPECT_TRUE(has_same("sum-1") && has_same("sum-2"));
}

TEST_F(Edited, TheNameOfAnAnalysisMakesNothing) {
    expect_counts(edit([](Project& p) { p.analyses[0].name = "another"; }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 5});
    EXPECT_EQ(now->analysis("sum-1")->name, "another");
    EXPECT_EQ(now->analysis("sum-1")->model, before->analysis("sum-1")->model);
    EXPECT_TRUE(same_numbers(*now->analysis("sum-1"), *before->analysis("sum-1")));
    EXPECT_TRUE(has_same("sum-2"));
}

TEST_F(Edited, AnAssetMakesItselfAndWhatUsesIt) {
    ASSERT_TRUE(before->analysis("sum-2")->propagated->propagation());
    expect_counts(edit([](Project& p) { p.assets[0].setup.values["rounds"] = Quantity{7.0}; }),
                  {.assets = 2, .models = 1, .inputs = 1, .taken = 2});
    EXPECT_FALSE(has_same("sum-1"));
    EXPECT_FALSE(same_numbers(*now->analysis("sum-1"), *before->analysis("sum-1")));
    EXPECT_FALSE(now->analysis("sum-1")->propagated->is_computed());
    EXPECT_TRUE(has_same("sum-2"));
    expect_counts(edit([](Project& p) { p.assets[2].setup.values["rounds"] = Quantity{8.0}; }),
                  {.assets = 3, .models = 2, .inputs = 2, .taken = 0});
}

TEST_F(Edited, TheNameOfAnAssetIsSaidAnewAndNothingIsEvaluated) {
    ASSERT_TRUE(before->analysis("sum-1")->propagated->propagation());
    expect_counts(edit([](Project& p) { p.assets[0].name = "another"; }),
                  {.assets = 1, .models = 1, .inputs = 1, .taken = 3});
    EXPECT_EQ(now->assets().find("block-1")->name, "another");
    EXPECT_EQ(now->assets().find("block-1")->asset, before->assets().find("block-1")->asset);
    EXPECT_TRUE(shares_law("sum-1"));
    EXPECT_TRUE(same_numbers(*now->analysis("sum-1"), *before->analysis("sum-1")));
    EXPECT_EQ(now->analysis("sum-1")->fingerprint(), before->analysis("sum-1")->fingerprint());
}

TEST_F(Edited, OptionsRequirementsAndStudiesMakeNoModel) {
    ASSERT_TRUE(before->analysis("sum-1")->propagated->propagation());
    expect_counts(edit([](Project& p) { p.analyses[0].options.seed = 7; }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 5});
    EXPECT_FALSE(has_same("sum-1"));
    EXPECT_EQ(now->analysis("sum-1")->options.seed, 7u);
    EXPECT_FALSE(same_numbers(*now->analysis("sum-1"), *before->analysis("sum-1")));
    EXPECT_TRUE(shares_law("sum-1"));
    before = now;
    Requirement limit{"lengths", "y"};
    limit.upper_limit = Quantity{2000.0, Unit::of("mm")};
    expect_counts(edit([&](Project& p) { p.analyses[0].requirements = {limit}; }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 5});
    EXPECT_TRUE(same_numbers(*now->analysis("sum-1"), *before->analysis("sum-1")));
    before = now;
    StudyAxis axis{.target = "/setup/gain", .from = 1.0, .to = 2.0};
    expect_counts(edit([&](Project& p) {
                      p.analyses[0].studies = {{"s", "", {axis}, {}}};
                  }),
                  {.assets = 0, .models = 0, .inputs = 0, .taken = 5});
    EXPECT_TRUE(has_same("sum-1"));
}

TEST_F(Edited, AnEditedInputKeepsTheModel) {
    expect_counts(edit([](Project& p) { p.analyses[0].inputs.pop_back(); }),
                  {.assets = 0, .models = 0, .inputs = 1, .taken = 5});
    EXPECT_EQ(now->analysis("sum-1")->model, before->analysis("sum-1")->model);
}

TEST_F(Edited, OneLawServesForecastLiveResultsAndRuns) {
    edit([](Project& p) {
        p.analyses[0].options.method = Method::adaptive;
        p.analyses[0].options.minimum_batches = 2;
        p.analyses[0].options.maximum_trials = 20'000;
        p.analyses[0].options.significant_digits = 1;
    });
    const PreparedAnalysis& analysis = *now->analysis("sum-1");
    EXPECT_FALSE(analysis.forecast.empty());
    ASSERT_TRUE(analysis.propagated->is_computed());
    const auto live = evaluate_first_order(*analysis.propagated, analysis.options);
    const auto alone = evaluate_first_order(*analysis.model, analysis.inputs, analysis.options);
    const auto run = run_analysis(analysis);
    ASSERT_TRUE(live && alone && run);
    EXPECT_EQ(first_order_covariance(*live), first_order_covariance(*alone));
    EXPECT_EQ(first_order_covariance(*run), first_order_covariance(*alone));
}

TEST_F(Edited, ProblemsFollowTheirEntryToItsNewPlace) {
    project.assets[0].setup.values.erase("length");
    before = MadeProject::make(project, before);
    EXPECT_EQ(problem_with(before->problems(), "must be given").path, "/assets/0/setup/length");
    std::swap(project.assets[0], project.assets[2]);
    now = MadeProject::make(project, before);
    EXPECT_EQ(problem_with(now->problems(), "must be given").path, "/assets/2/setup/length");
    EXPECT_EQ(now->problems().items().size(), before->problems().items().size());
    EXPECT_EQ(now->counts().assets + now->counts().models, 0u);
    EXPECT_EQ(now->analysis("sum-1"), nullptr);
    EXPECT_EQ(now->analysis("sum-2"), before->analysis("sum-2"));
}

TEST_F(Edited, WhatIsMissingIsLookedForAgain) {
    const AssetEntry block = project.assets[0];
    project.assets.erase(project.assets.begin());
    now = MadeProject::make(project, before);
    EXPECT_EQ(
        problem_with(now->problems(), "'clamped block' refers to the asset 'block-1', which does not exist")
            .path,
        "/assets/0/setup/block");
    EXPECT_EQ(now->analysis("sum-1"), nullptr);
    project.assets.push_back(block);
    const auto again = MadeProject::make(project, now);
    EXPECT_TRUE(again->problems().empty());
    EXPECT_TRUE(again->analysis("sum-1"));
}

TEST_F(Edited, ACircleIsRefusedWithItsWay) {
    AssetEntry clamp = project.assets[1];
    clamp.id = "clamp_3";
    clamp.name = "third clamp";
    clamp.setup.values["block"] = std::string("clamp_4");
    project.assets.push_back(clamp);
    clamp.id = "clamp_4";
    clamp.name = "fourth clamp";
    clamp.setup.values["block"] = std::string("clamp_3");
    project.assets.push_back(clamp);
    now = MadeProject::make(project, before);
    const Problem circle = problem_with(now->problems(), "which refers back to this one");
    EXPECT_EQ(circle.path, "/assets/4/setup/block");
    EXPECT_NE(circle.message.english().find("'third clamp' → 'fourth clamp' → 'third clamp'"),
              std::string::npos)
        << circle.message;
    EXPECT_EQ(problem_with(now->problems(), "which has errors of its own").path, "/assets/3/setup/block");
    EXPECT_EQ(now->problems().items().size(), 2u);
    EXPECT_TRUE(has_same("sum-1")) << "and nothing else is concerned";
}

TEST_F(Edited, TwoWithOneIdAreSaidAndTheFirstCounts) {
    project.assets[2].id = "block-1";
    project.analyses[1].setup.values["block"] = std::string("block-1");
    project.assets[2].name = "the second";
    now = MadeProject::make(project, before);
    EXPECT_EQ(problem_with(now->problems(), "another one has the same id").path, "/assets/2/id");
    EXPECT_EQ(now->assets().find("block-1")->name, "the block");
}

}  // namespace
}  // namespace covaria::test::made_project_test
