// States that are kept: in the file and back, that no number depends on them, and the way back to one.
#include "core/project/kept_state.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/project/linked_files.h"
#include "core/project/project_file.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::kept_state_test {
namespace {

constexpr const char* when = "2026-11-20T09:30:00Z";

Project a_project() {
    return parse(whole_project).project;
}

const std::string& some_analysis(const Project& project) {
    return project.analyses.front().id;
}

TEST(KeptState, KeepsTheNumbersOfTheResultsAndAllElseAsItIsNow) {
    const Project of_results = a_project();
    Project now = of_results;
    now.analyses.front().designs.push_back({.id = "design-new", .name = "Added while results were made"});
    now.analyses.front().notes = "written since";
    now.analyses.front().requirements.push_back({.group = "", .symbol = "required since"});
    now.assets.front().notes = "said since";
    now.analyses.front().options.seed += 1;
    const KeptState kept = state_to_keep(of_results, now, some_analysis(now), when);
    const AnalysisEntry& entry = kept.project->analyses.front();
    EXPECT_EQ(entry.designs, now.analyses.front().designs);
    EXPECT_EQ(entry.notes, now.analyses.front().notes);
    EXPECT_EQ(entry.requirements, now.analyses.front().requirements);
    EXPECT_EQ(kept.project->assets.front().notes, "said since");
    EXPECT_EQ(fingerprint(*kept.project), fingerprint(of_results)) << "no number is another";
    EXPECT_EQ(entry.options, of_results.analyses.front().options);
}

TEST(KeptState, ComesBackFromTheFileAndChangesNoNumber) {
    Project project = a_project();
    EXPECT_EQ(project_text(project).find("\"kept\":"), std::string::npos);
    project.results.coverage_factor = 2.5;
    const Project before = project;
    put_kept(project.kept, state_to_keep(project, some_analysis(project), when));
    project.analyses.front().options.seed += 1;
    project.results.coverage_factor = 3.0;
    const std::string text = project_text(project);
    const LoadedProject loaded = parse(text);
    EXPECT_TRUE(loaded.problems.items().empty());
    EXPECT_EQ(loaded.project.kept, project.kept);
    EXPECT_TRUE(loaded.project == project);
    EXPECT_EQ(project_text(loaded.project), text);
    const KeptState* kept = find_kept(loaded.project.kept, some_analysis(project));
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(kept->at, when);
    EXPECT_EQ(fingerprint(*kept->project), fingerprint(before));

    Project without = project;
    discard_kept(without.kept, some_analysis(project));
    EXPECT_TRUE(without.kept.empty());
    EXPECT_FALSE(without == project) << "keeping is an edit";
    EXPECT_EQ(fingerprint(without), fingerprint(project));
    EXPECT_TRUE(same_numbers(without, project));
}

TEST(KeptState, AnotherAnalysisMayStandInItsPlace) {
    Project project = a_project();
    const std::string id = some_analysis(project);
    Project elsewhere = a_project();
    elsewhere.analyses.front().id = "elsewhere";
    put_kept(project.kept, state_of_other(elsewhere, "elsewhere", "hall.covaria: elsewhere", id, when));
    const LoadedProject loaded = parse(project_text(project));
    EXPECT_TRUE(loaded.problems.items().empty());
    ASSERT_EQ(loaded.project.kept, project.kept);
    EXPECT_EQ(loaded.project.kept.front().compared(), "elsewhere");
    EXPECT_EQ(loaded.project.kept.front().project->analyses.size(), 1u) << "no more than it needs";
    std::string nameless = project_text(project);
    nameless.replace(nameless.find("\"otherName\""), 11, "\"otherTitle\"");
    EXPECT_TRUE(parse(nameless).problems.has_errors());
    EXPECT_EQ(loaded.project.kept.front().other_name, "hall.covaria: elsewhere");
    EXPECT_EQ(state_to_keep(project, id, when).compared(), id);
}

TEST(KeptState, OneOfAnAnalysisTakesThePlaceOfTheOther) {
    Project project = a_project();
    const std::string id = some_analysis(project);
    put_kept(project.kept, state_to_keep(project, id, when));
    put_kept(project.kept, state_to_keep(project, id, "2026-11-21T09:30:00Z"));
    ASSERT_EQ(project.kept.size(), 1u);
    EXPECT_EQ(project.kept.front().at, "2026-11-21T09:30:00Z");
    EXPECT_TRUE(project.kept.front().project->kept.empty()) << "a state keeps none";
}

TEST(KeptState, GoingBackLeavesWhatTheAnalysisDoesNotUse) {
    Project project = a_project();
    const std::string id = some_analysis(project);
    const Project before = project;
    put_kept(project.kept, state_to_keep(project, id, when));
    project.notes = "written later";
    project.analyses.front().options.seed += 1;
    project.results.coverage_factor = 3.0;
    AnalysisEntry later = project.analyses.front();
    later.id = "later";
    project.analyses.push_back(later);
    put_kept(project.kept, state_to_keep(project, "later", when));
    const std::vector<KeptState> kept = project.kept;
    go_back(project, project.kept.front());
    ASSERT_EQ(project.analyses.size(), before.analyses.size() + 1) << "what was added since stays";
    EXPECT_EQ(project.analyses.back(), later);
    project.analyses.pop_back();
    EXPECT_EQ(project.analyses, before.analyses);
    EXPECT_EQ(project.assets, before.assets);
    EXPECT_EQ(project.results, before.results);
    EXPECT_EQ(project.notes, "written later");
    EXPECT_EQ(project.kept, kept);
}

/// The whole project with its readings in a file.
Project with_readings_in(const std::filesystem::path& folder, const std::string& csv) {
    put_bytes(folder / "readings.csv", csv);
    const std::string text =
        changed("{\n          \"columns\": [\"point\", \"value [mm]\"],\n          \"rows\": []\n        }",
                "{\"csv\": \"readings.csv\"}");
    return parse_project(text, folder, "test.covaria").project;
}

TEST(KeptState, HasTheRowsOfAFileWhateverBecomesOfIt) {
    const auto folder = fresh_folder("kept-csv");
    Project project = with_readings_in(folder, "point,value [mm]\nA,1\nB,2\n");
    ASSERT_EQ(linked_files(project).size(), 1u);
    const Project before = project;
    put_kept(project.kept, state_to_keep(project, some_analysis(project), when));
    put_bytes(folder / "readings.csv", "point,value [mm]\nA,1\nB,3\n");
    Project tomorrow = parse_project(project_text(project), folder, "test.covaria").project;
    EXPECT_FALSE(same_numbers(tomorrow, before));
    EXPECT_TRUE(same_numbers(*tomorrow.kept.front().project, before));
    go_back(tomorrow, tomorrow.kept.front());
    EXPECT_TRUE(same_numbers(tomorrow, before));
    EXPECT_TRUE(linked_files(tomorrow).empty()) << "the file says something else";

    go_back(project, project.kept.front());
    EXPECT_EQ(project.analyses, before.analyses);
    EXPECT_EQ(project.assets, before.assets) << "still of the file";
}

TEST(KeptState, WhatIsWrongIsRefusedWithItsPlace) {
    Project project = a_project();
    put_kept(project.kept, state_to_keep(project, some_analysis(project), when));
    const nlohmann::ordered_json good = nlohmann::ordered_json::parse(project_text(project));
    const auto place = [&](const auto& spoil, const std::string& words) {
        nlohmann::ordered_json bad = good;
        spoil(bad["kept"]);
        const LoadedProject loaded = parse(bad.dump());
        EXPECT_FALSE(loaded.is_whole);
        return problem_with(loaded.problems, words).path;
    };
    EXPECT_EQ(place([](auto& kept) { kept[0].erase("analysis"); }, "'analysis'"), "/kept/0/analysis");
    EXPECT_EQ(place([](auto& kept) { kept[0]["notes"] = "x"; }, "'notes'"), "/kept/0/notes");
    EXPECT_EQ(place([](auto& kept) { kept.push_back(kept[0]); }, "two states"), "/kept/1/analysis");
    EXPECT_EQ(place([](auto& kept) { kept[0]["assets"][0]["setup"]["nothing"] = 1; }, "'nothing'"),
              "/kept/0/assets/0/setup/nothing");
}

}  // namespace
}  // namespace covaria::test::kept_state_test
