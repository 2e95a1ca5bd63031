// Sessions as a user has them, through the real widgets.
#include <QAction>
#include <QClipboard>
#include <QLineEdit>
#include <QTableView>
#include <QUndoStack>

#include "tests/ui/main_window/window_fixture.h"
#include "ui/forms/setup_form.h"
#include "ui/forms/spreadsheet_view.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/sortable_table.h"
#include "ui/scene_view/scene_panel.h"

namespace covaria::ui {
namespace {

class Session : public WindowFixture {
protected:
    /// Types into the first visible field of the properties with this name.
    void type_into(const char* field, const QString& text) {
        auto* edit = window_->properties().findChild<QLineEdit*>(QString::fromLatin1(field));
        ASSERT_NE(edit, nullptr) << field;
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    double expanded_uncertainty(const QString& analysis, std::size_t output) const {
        return window_->runner().status(analysis).result->outputs[output].expanded_uncertainty;
    }
    void select(SetupOwner owner, const std::string& id) { window_->selection().select_entry({owner, id}); }
};

TEST_F(Session, AnEditedUncertaintyChangesTableChartAndScene) {
    open(project_copy());
    wait_until_idle();
    const QString analysis = window_->selection().analysis();
    ASSERT_FALSE(analysis.isEmpty());
    const double before = expanded_uncertainty(analysis, 2);
    window_->scene().view().service().wait_until_idle();
    QCoreApplication::processEvents();
    const QImage scene_before = window_->scene().view().image();
    ASSERT_FALSE(scene_before.isNull());
    const QString cell_before = window_->results().result_table().csv();

    type_into("base_u_z", QStringLiteral("1.05 mm"));
    wait_until_idle();
    EXPECT_GT(expanded_uncertainty(analysis, 2), 2.0 * before);
    EXPECT_NE(window_->results().result_table().csv(), cell_before);
    for (int i = 0;
         i < 200 && (window_->scene().is_building() || window_->scene().view().image() == scene_before); ++i)
        QTest::qWait(50);
    EXPECT_NE(window_->scene().view().image(), scene_before);
}

TEST_F(Session, FiftyEditsUndoneGiveTheSavedBytes) {
    const QString file = project_copy();
    open(file);
    const std::string saved = bytes();
    for (int i = 0; i < 50; ++i) {
        window_->document().end_merging();
        type_into("base_u_x", QString::number(0.07 + 0.001 * i) + QStringLiteral(" mm"));
    }
    EXPECT_EQ(window_->document().undo_stack().count(), 50);
    EXPECT_NE(bytes(), saved);
    while (window_->document().undo_stack().canUndo()) window_->document().undo_stack().undo();
    EXPECT_EQ(bytes(), saved);
    QFile on_disk(file);
    ASSERT_TRUE(on_disk.open(QIODevice::ReadOnly));
    EXPECT_EQ(on_disk.readAll().toStdString(), saved);
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(Session, AFourthBasePointIsTypedIn) {
    open(project_copy());
    wait_until_idle();
    const std::size_t inputs_before =
        window_->runner().status(window_->selection().analysis()).prepared->inputs.quantities.size();
    auto* table = window_->properties().findChild<QTableView*>(QStringLiteral("base_points"));
    ASSERT_NE(table, nullptr);
    const int rows = table->model()->rowCount();
    QGuiApplication::clipboard()->setText(QStringLiteral("b4\t0\t-100\t5"));
    table->setCurrentIndex(table->model()->index(rows - 1, 0));
    auto* sheet = qobject_cast<SpreadsheetView*>(table);
    ASSERT_NE(sheet, nullptr);
    QTest::keyClick(sheet, Qt::Key_Insert);
    table->setCurrentIndex(table->model()->index(std::min(rows, table->model()->rowCount() - 1), 0));
    QTest::keySequence(sheet, QKeySequence::Paste);
    wait_until_idle();
    const auto prepared = window_->runner().status(window_->selection().analysis()).prepared;
    ASSERT_NE(prepared, nullptr)
        << window_->runner().status(window_->selection().analysis()).message.toStdString();
    EXPECT_EQ(prepared->inputs.quantities.size(), inputs_before + 3);
}

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
