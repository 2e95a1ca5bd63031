// Sessions as a user has them, through the real widgets.
#include <QUndoStack>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/sortable_table.h"

namespace covaria::ui {
namespace {

TEST_F(Session, AReportIsExportedWithoutBlocking) {
    open(project_copy());
    wait_until_idle();
    const QString file = folder_.filePath(QStringLiteral("report.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().export_report_to(file, ReportFormat::pdf);
    EXPECT_FALSE(QFile::exists(file)) << "writing goes on in the background";
    ASSERT_TRUE(finished.wait(120'000));
    EXPECT_EQ(finished[0][1].toString(), QString());
    QFile pdf(file);
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.readAll().startsWith("%PDF-"));
}

TEST_F(Session, EntriesAreAddedDuplicatedAndDeleted) {
    open(project_copy());
    const std::size_t assets = window_->document().project().assets.size();
    const std::string first = window_->document().project().assets.front().id;
    select(SetupOwner::asset, first);
    window_->project_pane().duplicate_action->trigger();
    EXPECT_EQ(window_->document().project().assets.size(), assets + 1);
    window_->project_pane().delete_action->trigger();
    EXPECT_EQ(window_->document().project().assets.size(), assets);
    EXPECT_NE(window_->document().project().find_asset(first), nullptr)
        << "the copy was selected, and is gone";
    window_->document().undo_stack().undo();
    window_->document().undo_stack().undo();
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(Session, ARunIsStopped) {
    open(project_copy());
    wait_until_idle();
    const QString id = window_->selection().analysis();
    window_->document().apply(QStringLiteral("More trials"), [&](Project& project) {
        for (AnalysisEntry& analysis : project.analyses) analysis.options.trials = 500'000'000;
    });
    window_->runner().run(id);
    for (int i = 0; i < 100 && window_->runner().status(id).state != RunState::running; ++i) QTest::qWait(20);
    ASSERT_EQ(window_->runner().status(id).state, RunState::running);
    window_->runner().stop_all();
    ASSERT_TRUE(window_->runner().wait_until_idle(5'000));
    EXPECT_NE(window_->runner().status(id).state, RunState::running);
}

TEST_F(Session, ABrokenFileIsRefusedInWordsAndTheProjectStays) {
    open(project_copy());
    const std::string before = bytes();
    const QString broken = folder_.filePath(QStringLiteral("broken.covaria"));
    QFile file(broken);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"covaria\", \"schemaVersion\": 1, \"title\": \"x\", \"assets\": [");
    file.close();
    open(broken);
    ASSERT_EQ(answer_.messages.size(), 1);
    EXPECT_TRUE(answer_.messages[0].contains(QStringLiteral("broken.covaria")));
    EXPECT_EQ(bytes(), before);
}

TEST_F(Session, SavingWhereNothingCanBeWrittenSaysSo) {
    open(project_copy());
    type_into("base_u_x", QStringLiteral("0.08 mm"));
    answer_.file_to_save = QStringLiteral("/proc/nowhere/project.covaria");
    EXPECT_FALSE(window_->files().save_as());
    EXPECT_EQ(answer_.messages.size(), 1);
    EXPECT_TRUE(window_->document().is_modified());
}

TEST_F(Session, ClosingWithUnsavedChangesAsks) {
    open(project_copy());
    type_into("base_u_x", QStringLiteral("0.08 mm"));
    answer_.save = SaveAnswer::cancel;
    EXPECT_FALSE(window_->close());
    EXPECT_EQ(answer_.save_questions, 1);
    EXPECT_TRUE(window_->isVisible());
    answer_.save = SaveAnswer::save;
    EXPECT_TRUE(window_->close());
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(Session, UnsavedWorkIsOfferedAfterACrash) {
    open(project_copy());
    type_into("base_u_x", QStringLiteral("0.08 mm"));
    const std::string edited = bytes();
    // What a crash leaves: a recovery file whose owner is gone.
    RecoveryStore store(folder_.filePath(QStringLiteral("recovery")));
    ASSERT_TRUE(
        RecoveryStore::write(store.new_name(), window_->document().project(), window_->document().file()));
    make_window();
    answer_.recover = 0;
    window_->begin({});
    EXPECT_EQ(bytes(), edited);
    EXPECT_TRUE(window_->document().is_modified());
}

TEST_F(Session, SelectingAnOutputSelectsItInTableAndCharts) {
    open(project_copy());
    wait_until_idle();
    window_->selection().select_output(4);
    EXPECT_EQ(window_->results().result_table().current_row(), 4);
    window_->selection().select_group(QStringLiteral("pose 7"));
    EXPECT_EQ(window_->scene().group(), QStringLiteral("pose 7"));
}

}  // namespace
}  // namespace covaria::ui
