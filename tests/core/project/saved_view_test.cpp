// Saved views: in the file and back, what is refused, and that no number depends on them.
#include "core/project/saved_view.h"

#include <gtest/gtest.h>

#include "core/project/project_file.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::saved_view_test {
namespace {

SavedView a_view(const std::string& name) {
    SavedView view;
    view.name = name;
    view.direction = {0.6, 0.8, 0};
    view.centre = {1.5, -0.25, 0.75};
    view.width = 3.2;
    view.height = 2;
    return view;
}

TEST(SavedView, ComesBackFromTheFileAndChangesNoNumber) {
    Project project = parse(whole_project).project;
    EXPECT_EQ(project_text(project).find("\"views\":"), std::string::npos);
    const Project before = project;
    SavedView closer = a_view("closer");
    closer.perspective = true;
    closer.hidden = {"body:base", "link:leg 3"};
    closer.only = "body:moving platform";
    project.analyses.front().views = {a_view("from the door"), closer};
    EXPECT_FALSE(project == before);
    EXPECT_EQ(fingerprint(project), fingerprint(before));
    EXPECT_TRUE(same_numbers(project, before));
    const std::string text = project_text(project);
    const LoadedProject loaded = parse(text);
    EXPECT_TRUE(loaded.problems.items().empty());
    EXPECT_EQ(loaded.project.analyses.front().views, project.analyses.front().views);
    EXPECT_EQ(project_text(loaded.project), text);
}

TEST(SavedView, IsFoundByItsName) {
    const std::vector<SavedView> views{a_view("a"), a_view("b")};
    EXPECT_EQ(find_view(views, "b"), &views[1]);
    EXPECT_EQ(find_view(views, "c"), nullptr);
}

/// The problems of a project whose only view is the usual one with `now` in the place of `was`.
std::string problems_with(const std::string& was, const std::string& now) {
    Project project = parse(whole_project).project;
    project.analyses.front().views = {a_view("door"), a_view("window")};
    std::string text = project_text(project);
    const std::size_t at = text.find(was, text.find("\"views\""));
    if (at == std::string::npos) return "not there: " + was;
    std::string words;
    const LoadedProject loaded = parse(text.replace(at, was.size(), now));
    for (const Problem& problem : loaded.problems.items())
        words += problem.path + ": " + problem.message.english() + "\n";
    return words;
}

TEST(SavedView, WhatIsWrongIsRefusedWithItsPlace) {
    EXPECT_EQ(problems_with("\"width\"", "\"width\""), "");
    const auto expect = [](const std::string& words, const std::string& path, const std::string& part) {
        EXPECT_NE(words.find("/analyses/0/views/" + path), std::string::npos) << words;
        EXPECT_NE(words.find(part), std::string::npos) << words;
    };
    expect(problems_with("\"window\"", "\"door\""), "1/name", "used twice");
    expect(problems_with("\"door\"", "\"top\""), "0/name", "standard view");
    expect(problems_with("\"width\": 3.2", "\"width\": 0"), "0/width", "greater than zero");
    expect(problems_with("\"direction\": [0.6, 0.8, 0]", "\"direction\": [0, 0, 2]"), "0/up", "different");
    expect(problems_with("\"direction\": [0.6, 0.8, 0]", "\"direction\": [0.6, 0.8]"), "0/direction",
           "three numbers");
    expect(problems_with("\"lengthUnit\": \"m\"", "\"lengthUnit\": \"kg\""), "0/lengthUnit",
           "unit of length");
    expect(problems_with("\"width\": 3.2", "\"wide\": 3.2"), "0", "wide");
}

TEST(SavedView, LengthsAreInTheirUnit) {
    Project project = parse(whole_project).project;
    project.analyses.front().views = {a_view("door")};
    std::string text = project_text(project);
    const std::string was = "\"lengthUnit\": \"m\"";
    text.replace(text.find(was, text.find("\"views\"")), was.size(), "\"lengthUnit\": \"mm\"");
    const LoadedProject loaded = parse(text);
    EXPECT_TRUE(loaded.problems.items().empty());
    EXPECT_DOUBLE_EQ(loaded.project.analyses.front().views.front().width, 3.2e-3);
    EXPECT_DOUBLE_EQ(loaded.project.analyses.front().views.front().centre[0], 1.5e-3);
}

}  // namespace
}  // namespace covaria::test::saved_view_test
