// Sessions as a user has them, through the real widgets.
#include <QUndoStack>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"

namespace covaria::ui::session_test {
namespace {

TEST_F(Session, AReportIsExportedWithoutBlocking) {
    open(project_copy());
    wait_until_idle();
    const QString file = folder_.filePath(QStringLiteral("report.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().export_document_to(file, DocumentKind::report, ReportFormat::pdf);
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

TEST_F(Session, SelectingAnOutputSelectsItInTableAndCharts) {
    open(project_copy());
    wait_until_idle();
    window_->selection().select_output(4);
    EXPECT_EQ(window_->results().outputs().table().current_row(), 4);
    window_->selection().select_group(QStringLiteral("pose 7"));
    EXPECT_EQ(window_->scene().group(), QStringLiteral("pose 7"));
}

}  // namespace
}  // namespace covaria::ui::session_test
