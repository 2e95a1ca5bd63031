// Every template gives an analysis with results, alone and beside what a project has already.
#include "core/made/analysis_templates.h"

#include <gtest/gtest.h>

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

TEST(AnalysisTemplates, ATrackerThatCannotSeeTheTargetsIsNotTaken) {
    Project project = *template_project(from_tracker());
    project.analyses.clear();
    AssetEntry& mine = project.assets.front();
    mine.id = "mine";
    mine.setup.values["kind"] = std::string("tracker");
    mine.setup.values["view_farthest"] = Quantity{0.001, Unit::of("m")};
    const auto id = add_template(project, from_tracker());
    ASSERT_TRUE(id);
    EXPECT_EQ(project.assets.size(), 2U) << "the template's own came with it";
}

}  // namespace
}  // namespace covaria::analysis_templates_test
