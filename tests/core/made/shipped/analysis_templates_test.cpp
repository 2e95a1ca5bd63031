// Every template gives an analysis with results, alone and beside what a project has already.
#include "core/made/analysis_templates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/kinds/registries.h"
#include "core/made/made_project.h"
#include "core/made/prepared_analysis.h"
#include "core/propagation/engine.h"

namespace covaria::analysis_templates_test {
namespace {

void expect_value(const Project& project, const std::string& id, const std::string& what) {
    const MadeProject::Pointer made = MadeProject::make(project);
    const Problems problems = made->problems();
    for (const Problem& problem : problems.items())
        EXPECT_NE(problem.severity, Severity::error)
            << what << ": " << problem.path << ": " << problem.message.english();
    const auto prepared = made->analysis(id);
    ASSERT_NE(prepared, nullptr) << what;
    const auto result = evaluate_first_order(*prepared->propagated, prepared->options);
    ASSERT_TRUE(result) << what << ": " << result.error().message.english();
    bool any = false;
    for (const OutputResult& output : result->outputs)
        any = any || output.first_order.standard_uncertainty > 0;
    EXPECT_TRUE(any) << what;
}

void expect_error_said(const Project& project, const std::string& id) {
    const MadeProject::Pointer made = MadeProject::make(project);
    const auto prepared = made->analysis(id);
    const Problems problems = made->problems();
    const bool said = std::ranges::any_of(
        problems.items(), [](const Problem& problem) { return problem.severity == Severity::error; });
    EXPECT_TRUE(said || (prepared && !evaluate_first_order(*prepared->propagated, prepared->options)));
}

TEST(AnalysisTemplates, EachHasAResultAsMade) {
    std::set<std::string> titles;
    for (const AnalysisTemplate& known : analysis_templates()) {
        Project project;
        const auto id = add_template(project, known);
        ASSERT_TRUE(id) << known.title << ": " << id.error().message.english();
        EXPECT_EQ(project.analyses.back().name, known.title);
        EXPECT_TRUE(titles.insert(known.title).second) << known.title;
        expect_value(project, *id, known.title);
    }
}

TEST(AnalysisTemplates, NameAndNotesAreInTheReadersLanguage) {
    const AnalysisTemplate& known = analysis_templates().front();
    const DocumentLanguage german("de", {}, [&](const std::string& english) {
        return english == known.title      ? "Getippte Gleichung"
               : english == known.question ? "Eine Frage"
                                           : english;
    });
    Project project;
    for (const char* name : {"Getippte Gleichung", "Getippte Gleichung (2)"}) {
        ASSERT_TRUE(add_template(project, known, german));
        EXPECT_EQ(project.analyses.back().name, name);
        EXPECT_EQ(project.analyses.back().notes, "Eine Frage");
    }
}

TEST(AnalysisTemplates, AllStandTogetherInOneProject) {
    Project project;
    for (const AnalysisTemplate& known : analysis_templates()) {
        const auto id = add_template(project, known);
        ASSERT_TRUE(id) << known.title;
        expect_value(project, *id, known.title);
    }
    std::set<std::string> names;
    for (const AnalysisEntry& analysis : project.analyses) EXPECT_TRUE(names.insert(analysis.name).second);
    for (const AssetEntry& asset : project.assets) EXPECT_TRUE(names.insert(asset.name).second) << asset.name;
}

TEST(AnalysisTemplates, EveryModelHasOne) {
    for (const ModelDescriptor& model : model_registry()) {
        const AnalysisTemplate* known = template_of(model.id);
        ASSERT_NE(known, nullptr) << model.id;
        EXPECT_EQ(template_project(*known)->analyses.back().model, model.id);
    }
}

const AnalysisTemplate& from_tracker() {
    for (const AnalysisTemplate& known : analysis_templates())
        if (known.analysis == "tracker-alone") return known;
    throw std::logic_error("no such template");
}

TEST(AnalysisTemplates, TheProjectsOwnTrackerStandsInThePlaceOfTheTemplates) {
    Project project = *template_project(from_tracker());
    project.analyses.clear();
    ASSERT_EQ(project.assets.size(), 1U);
    project.assets.front().id = "mine";
    project.assets.front().name = "My tracker";
    const auto id = add_template(project, from_tracker());
    ASSERT_TRUE(id);
    ASSERT_EQ(project.assets.size(), 1U) << "nothing was copied";
    expect_value(project, *id, "with the project's tracker");
}

TEST(AnalysisTemplates, ATrackerThatCannotSeeTheTargetsIsTakenAndItsErrorSaid) {
    Project project = *template_project(from_tracker());
    project.analyses.clear();
    AssetEntry& mine = project.assets.front();
    mine.id = "mine";
    mine.setup.values["kind"] = std::string("tracker");
    mine.setup.values["view_farthest"] = Quantity{0.001, Unit::of("m")};
    const auto id = add_template(project, from_tracker());
    ASSERT_TRUE(id);
    EXPECT_EQ(project.assets.size(), 1U) << "no other tracker came with it";
    expect_error_said(project, *id);
}

// A tracker from the library stands in the origin, among the targets, nearer than it measures.
TEST(AnalysisTemplates, ATrackerThatWasGivenNoPlaceStandsWhereTheTemplatesDoes) {
    Project project = *template_project(from_tracker());
    project.analyses.clear();
    AssetEntry& mine = project.assets.front();
    const SetupValue place = mine.setup.values.at("station");
    mine.id = "mine";
    mine.setup.values.erase("station");
    mine.setup.values["view_nearest"] = Quantity{0.8, Unit::of("m")};
    const auto id = add_template(project, from_tracker());
    ASSERT_TRUE(id);
    ASSERT_EQ(project.assets.size(), 1U) << "nothing was copied";
    EXPECT_EQ(project.assets.front().setup.values.at("station"), place);
    expect_value(project, *id, "with the project's tracker");
}

// A tracker that another analysis uses from the origin stays there.
TEST(AnalysisTemplates, ATrackerThatIsUsedIsNotMoved) {
    Project project = *template_project(from_tracker());
    AssetEntry& mine = project.assets.front();
    mine.setup.values.erase("station");
    mine.setup.values["view_nearest"] = Quantity{0.8, Unit::of("m")};
    const AssetEntry before = mine;
    const auto id = add_template(project, from_tracker());
    ASSERT_TRUE(id);
    EXPECT_EQ(project.assets.size(), 1U) << "no other tracker came with it";
    EXPECT_EQ(project.assets.front(), before);
    expect_error_said(project, *id);
}

// One of two assets is not complete yet: both are used, and what it lacks is said.
TEST(AnalysisTemplates, AnAssetThatIsNotCompleteIsUsedAllTheSame) {
    const auto wanted =
        std::ranges::find(analysis_templates(), "from-artefacts", &AnalysisTemplate::analysis);
    Project project = *template_project(*wanted);
    project.analyses.clear();
    ASSERT_EQ(project.assets.size(), 2U);
    for (AssetEntry& asset : project.assets) asset.id = "my-" + asset.id;
    project.assets.front().setup.values.clear();
    const std::string incomplete = project.assets.front().kind;
    const auto id = add_template(project, *wanted);
    ASSERT_TRUE(id);
    EXPECT_EQ(project.assets.size(), 2U) << "no other " << incomplete << " came with it";
    expect_error_said(project, *id);
}

/// Kind of an asset, with the sort that its set-up says: tracker, camera.
std::string kind_and_sort(const AssetEntry& asset) {
    const auto sort = asset.setup.values.find("kind");
    const auto* text = sort == asset.setup.values.end() ? nullptr : std::get_if<std::string>(&sort->second);
    return asset.kind + (text ? "/" + *text : std::string());
}

// Every template into the assets of every other one, each with other figures: an asset comes with the
// analysis only where all that the project has of its kind are used already.
TEST(AnalysisTemplates, NoAssetComesBesideOneOfItsKindThatIsNotUsed) {
    for (const AnalysisTemplate& others : analysis_templates()) {
        Project before = *template_project(others);
        before.analyses.clear();
        for (AssetEntry& asset : before.assets) asset.id = "my-" + asset.id;
        for (AssetEntry& asset : before.assets) asset.setup.values.clear();
        for (const AnalysisTemplate& known : analysis_templates()) {
            if (known.with_designs || before.assets.empty()) continue;
            Project project = before;
            const auto id = add_template(project, known);
            ASSERT_TRUE(id) << known.title;
            const std::vector<std::string> used = MadeProject::make(project)->assets_used_by(*id);
            std::set<std::string> come;
            for (std::size_t i = before.assets.size(); i < project.assets.size(); ++i)
                come.insert(kind_and_sort(project.assets[i]));
            for (const AssetEntry& own : before.assets)
                EXPECT_TRUE(!come.contains(kind_and_sort(own)) || std::ranges::count(used, own.id) == 1)
                    << known.title << " beside " << own.id;
        }
    }
}

}  // namespace
}  // namespace covaria::analysis_templates_test
