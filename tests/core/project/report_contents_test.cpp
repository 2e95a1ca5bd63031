// Contents of the report: one list of chapters, and what follows from it.
#include "core/project/report_contents.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::report_contents_test {
namespace {

TEST(ReportContents, AllGoesInThatIsNotLeftOut) {
    ReportContents contents;
    EXPECT_TRUE(contents.empty());
    for (const ReportChapterField& field : report_chapters()) EXPECT_TRUE(contents.has(field.chapter));
    choose(contents.without_chapters, "scene", false);
    choose(contents.without_chapters, "scene", false);
    EXPECT_EQ(contents.without_chapters, std::vector<std::string>{"scene"});
    for (const ReportChapterField& field : report_chapters())
        EXPECT_EQ(contents.has(field.chapter), field.chapter != ReportChapter::scene) << field.key;
    choose(contents.without_analyses, "a", false);
    EXPECT_FALSE(contents.has_analysis("a"));
    EXPECT_TRUE(contents.has_analysis("b"));
    choose(contents.without_analyses, "a", true);
    choose(contents.without_chapters, "scene", true);
    EXPECT_TRUE(contents.empty());
}

TEST(ReportContents, ComeBackFromTheFileAndChangeNoNumber) {
    Project project = parse(whole_project).project;
    EXPECT_EQ(project_text(project).find("\"report\":"), std::string::npos);
    const std::string before = fingerprint(project);
    project.report = {{project.analyses.front().id}, {"scene", "notes"}, true};
    EXPECT_EQ(fingerprint(project), before);
    const std::string text = project_text(project);
    const LoadedProject loaded = parse(text);
    EXPECT_TRUE(loaded.problems.items().empty());
    EXPECT_EQ(loaded.project.report, project.report);
    EXPECT_EQ(project_text(loaded.project), text);
    EXPECT_FALSE(loaded.project == parse(whole_project).project);
}

TEST(ReportContents, WhatThereIsNotIsRefusedAndAnAnalysisThatIsGoneIsWarnedOf) {
    Problems problems;
    check_report_contents({{"a", "gone"}, {"scene", "scenes"}, false}, {"a", "b"}, problems);
    ASSERT_EQ(problems.items().size(), 2U);
    EXPECT_EQ(problems.items()[0].path, "/report/withoutChapters/1");
    EXPECT_EQ(problems.items()[0].severity, Severity::error);
    EXPECT_NE(problems.items()[0].message.english().find("'scene'"), std::string::npos)
        << problems.items()[0].message.english();
    EXPECT_EQ(problems.items()[1].path, "/report/withoutAnalyses/1");
    EXPECT_EQ(problems.items()[1].severity, Severity::warning);
}

TEST(ReportContents, TheSchemaFileHasTheChapters) {
    std::ifstream in(data_directory() / "resources/schema/covaria-project.schema.json");
    const auto stated =
        nlohmann::json::parse(in)["$defs"]["report"]["properties"]["withoutChapters"]["items"]["enum"];
    nlohmann::json made = nlohmann::json::array();
    std::set<std::string> titles;
    for (const ReportChapterField& field : report_chapters()) {
        made.push_back(field.key);
        titles.insert(field.title);
    }
    EXPECT_EQ(stated, made);
    EXPECT_EQ(titles.size(), report_chapters().size());
}

}  // namespace
}  // namespace covaria::test::report_contents_test
