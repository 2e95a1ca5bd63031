// Editing, undo, merging of steps, problems.
#include "ui/document/document.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/ui/qt_application.h"
#include "ui/document/project_edits.h"

namespace covaria::ui::document_test {
namespace {

/// A problem for every project without a title.
Problems check_title(const MadeProject& made) {
    Problems problems;
    if (made.project().title.empty()) problems.error("/title", "the project has no title");
    return problems;
}

struct DocumentTest : testing::Test {
    bool set_title(const std::string& title, const QString& key = {}) {
        return document.apply(
            "Change title", [&](Project& project) { project.title = title; }, key);
    }
    Document document{check_title, nullptr};
};

TEST_F(DocumentTest, AppliesAndUndoes) {
    QSignalSpy changed(&document, &Document::project_changed);
    EXPECT_TRUE(set_title("a"));
    EXPECT_TRUE(document.is_modified());
    EXPECT_EQ(document.project().title, "a");
    document.undo_stack().undo();
    EXPECT_EQ(document.project(), Project{});
    EXPECT_FALSE(document.is_modified());
    document.undo_stack().redo();
    EXPECT_EQ(document.project().title, "a");
    EXPECT_EQ(changed.count(), 3);
}

// A field that is left with its entry ends what is typed in it: in the middle of another step.
TEST_F(DocumentTest, AnEditInsideAStepIsTheNextStep) {
    const auto follow = [&] {
        const std::string title = document.project().title;
        if (title == "one") document.apply("Notes", [](Project& project) { project.notes = "left"; });
    };
    QObject::connect(&document, &Document::project_changed, &document, follow);
    document.apply("Title", [](Project& project) { project.title = "one"; });
    EXPECT_EQ(document.project().notes, "left");
    EXPECT_EQ(document.undo_stack().count(), 2);
    document.apply("Title", [](Project& project) { project.title = "two"; });
    document.undo_stack().undo();
    EXPECT_EQ(document.project().title, "one");
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_EQ(document.project().title, "");
    EXPECT_EQ(document.project().notes, "");
}

TEST_F(DocumentTest, AnEditInsideUndoingIsTheNextStep) {
    document.apply("Title", [](Project& project) { project.title = "one"; });
    document.apply("Title", [](Project& project) { project.title = "two"; });
    const auto follow = [&] {
        if (document.project().title == "one")
            document.apply("Notes", [](Project& project) { project.notes = "left"; });
    };
    QObject::connect(&document, &Document::project_changed, &document, follow);
    document.undo_stack().undo();
    QCoreApplication::processEvents();
    EXPECT_EQ(document.project().notes, "left");
    EXPECT_EQ(document.project().title, "one");
    EXPECT_EQ(document.undo_stack().count(), 2);
}

TEST_F(DocumentTest, AnEditThatChangesNothingIsNoStep) {
    set_title("a");
    EXPECT_FALSE(set_title("a"));
    EXPECT_EQ(document.undo_stack().count(), 1);
}

TEST_F(DocumentTest, ASnapshotStaysAsItIs) {
    set_title("before");
    const ProjectSnapshot snapshot = document.snapshot();
    set_title("after");
    EXPECT_EQ(snapshot->title, "before");
}

TEST_F(DocumentTest, TypingMergesIntoOneStep) {
    for (const char* text : {"S", "St", "Ste"}) set_title(text, "title");
    EXPECT_EQ(document.undo_stack().count(), 1);
    set_title("other", "another field");
    EXPECT_EQ(document.undo_stack().count(), 2);
    document.undo_stack().undo();
    EXPECT_EQ(document.project().title, "Ste");
    document.undo_stack().undo();
    EXPECT_EQ(document.project().title, "");
}

TEST_F(DocumentTest, StepsWithoutKeyAndEndedDragsDoNotMerge) {
    set_title("a");
    set_title("b");
    EXPECT_EQ(document.undo_stack().count(), 2);
    set_title("c", "drag");
    document.end_merging();
    set_title("d", "drag");
    EXPECT_EQ(document.undo_stack().count(), 4);
}

TEST_F(DocumentTest, APauseEndsMerging) {
    document.set_merge_window(-1);  // any pause is too long
    set_title("a", "title");
    set_title("b", "title");
    EXPECT_EQ(document.undo_stack().count(), 2);
}

TEST_F(DocumentTest, AStepThatMergesToNothingDisappears) {
    set_title("a", "title");
    set_title("", "title");
    EXPECT_EQ(document.undo_stack().count(), 0);
    EXPECT_FALSE(document.is_modified());
}

TEST_F(DocumentTest, FiftyEditsUndoneGiveTheProjectBack) {
    Project start;
    start.title = "start";
    start.assets.push_back({"a", "kind", "Asset", {}, {}});
    start.analyses.push_back({"x", "model", "Analysis", {}, {}, {}, {}, {}, {}});
    document.replace(start);
    for (int i = 0; i < 50; ++i) {
        if (i % 3 == 0) set_title("title " + std::to_string(i));
        if (i % 3 == 1) duplicate(document, {SetupOwner::asset, "a"});
        if (i % 3 == 2)
            document.apply("Value", [i](Project& project) {
                project.analyses[0].setup.values["n"] = Quantity{i * 0.1, Unit::of("mm")};
            });
    }
    EXPECT_EQ(document.undo_stack().count(), 50);
    const Project end = document.project();
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(document.project(), start);
    while (document.undo_stack().canRedo()) document.undo_stack().redo();
    EXPECT_EQ(document.project(), end);
}

TEST_F(DocumentTest, ReplacingForgetsTheHistory) {
    QSignalSpy replaced(&document, &Document::project_replaced);
    set_title("a");
    document.replace({});
    EXPECT_EQ(replaced.count(), 1);
    EXPECT_FALSE(document.undo_stack().canUndo());
    EXPECT_FALSE(document.is_modified());
    document.restore({{}, {}, MadeProject::make(Project{})}, "/nowhere/x.covaria");
    EXPECT_TRUE(document.is_modified()) << "what was recovered has not been saved";
}

TEST_F(DocumentTest, ProblemsFollowInTheBackground) {
    set_title("a");
    set_title("");
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.problems().has_errors(); }));
    set_title("b");
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.problems().empty(); }));
    document.undo_stack().undo();
    document.check_now();
    ASSERT_EQ(document.problems().items().size(), 1u);
    EXPECT_EQ(document.problems().items()[0].path, "/title");
}

ProjectSnapshot titled(const std::string& title) {
    Project project;
    project.title = title;
    return std::make_shared<const Project>(project);
}

TEST(ProjectMaker, TheLatestSnapshotWins) {
    std::atomic<int> checks = 0;
    std::atomic<bool> all_requested = false;
    ProjectMaker maker(
        [&](const MadeProject& made) {
            ++checks;
            all_requested.wait(false);
            Problems problems;
            problems.error("/title", made.project().title);
            return problems;
        },
        Execution::threads, nullptr);
    for (int i = 0; i < 30; ++i) maker.request(titled(std::to_string(i)));
    all_requested = true;
    all_requested.notify_all();
    EXPECT_TRUE(maker.is_making());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !maker.is_making(); }));
    EXPECT_EQ(maker.problems().items().at(0).message.english(), "29");
    EXPECT_EQ(maker.made()->project().title, "29");
    EXPECT_LE(checks, 2) << "one that was running and the newest";
}

TEST(ProjectMaker, WhatIsMadeAlreadyIsNotMadeAgain) {
    ProjectMaker maker(Execution::inline_execution);
    QSignalSpy changed(&maker, &ProjectMaker::made_changed);
    const auto made = MadeProject::make(titled("a"));
    maker.take(made);
    EXPECT_EQ(maker.made(), made);
    maker.request(made->snapshot());
    EXPECT_EQ(changed.count(), 1);
    maker.request(titled("b"));
    EXPECT_EQ(maker.made()->project().title, "b");
    EXPECT_EQ(changed.count(), 2);
    QSignalSpy forgotten(&maker, &ProjectMaker::forgotten);
    maker.forget();
    EXPECT_EQ(forgotten.count(), 1);
    EXPECT_FALSE(maker.made());
}

TEST(ProjectEdits, IdsAndNamesAreUnique) {
    Project project;
    project.assets.push_back({"plate", "kind", "Plate", {}, {}});
    EXPECT_EQ(unique_id(project, "plate"), "plate-2");
    EXPECT_EQ(unique_id(project, "my plate/1"), "my-plate-1");
    EXPECT_EQ(unique_id(project, ""), "item");
    EXPECT_EQ(unique_name(project, "Plate"), "Plate (2)");
}

TEST_F(DocumentTest, EntriesAreDuplicatedRenamedMovedAndRemoved) {
    Project start;
    for (const char* id : {"a", "b"}) start.assets.push_back({id, "kind", id, {}, {}});
    document.replace(start);
    EXPECT_EQ(duplicate(document, {SetupOwner::asset, "a"}), "a-2");
    EXPECT_EQ(document.project().assets[1].name, "a (2)");
    rename(document, {SetupOwner::asset, "a-2"}, "Copy");
    move_entry(document, {SetupOwner::asset, "a-2"}, 2);
    EXPECT_EQ(document.project().assets[2].name, "Copy");
    remove(document, {SetupOwner::asset, "a"});
    EXPECT_EQ(document.project().assets.size(), 2u);
    EXPECT_EQ(add_asset(document, "no such kind"), "");
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(document.project(), start);
}

}  // namespace
}  // namespace covaria::ui::document_test
