// Importing a robot from URDF in the window: one undo step, a message where it cannot be.
#include <QApplication>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QUrl>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/import_dialog.h"
#include "ui/main_window/export_actions.h"
#include "ui/main_window/import_actions.h"

namespace covaria::ui::import_session_test {
namespace {

class ImportSession : public Session {
protected:
    void import(const char* text) {
        answer_.file_to_import = folder_.filePath(QStringLiteral("arm.urdf"));
        QFile file(answer_.file_to_import);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        window_->imports().urdf_action->trigger();
    }
};

TEST_F(ImportSession, ARobotBecomesAnAssetInOneStep) {
    open(project_copy());
    const std::size_t before = window_->document().project().assets.size();
    import(
        "<robot name=\"Arm\"><joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"l\"/>"
        "<axis xyz=\"0 0 1\"/></joint></robot>");
    EXPECT_TRUE(answer_.messages.isEmpty()) << answer_.messages.join(QLatin1Char('\n')).toStdString();
    ASSERT_EQ(window_->document().project().assets.size(), before + 1);
    const AssetEntry& robot = window_->document().project().assets.back();
    EXPECT_EQ(robot.name, "Arm");
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::asset, robot.id}));
    window_->document().undo_stack().undo();
    EXPECT_EQ(window_->document().project().assets.size(), before);
}

TEST_F(ImportSession, WhatIsNoRobotIsSaidAndLeftOut) {
    open(project_copy());
    const std::size_t before = window_->document().project().assets.size();
    import("<sdf/>");
    ASSERT_EQ(answer_.messages.size(), 1);
    EXPECT_TRUE(answer_.messages[0].contains(QStringLiteral("<robot> is missing")));
    EXPECT_EQ(window_->document().project().assets.size(), before);
}

class FileImportSession : public Session {
protected:
    /// Sends the events of a file that is dropped on the window.
    void let_go(const QString& file) {
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent event({10, 10}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &event);
    }
    ImportDialog* drop(const QString& file) {
        let_go(file);
        auto* dialog = window_->findChild<ImportDialog*>(QStringLiteral("import"));
        EXPECT_TRUE(dialog && wait_for([&] { return dialog->isVisible(); }));
        return dialog;
    }
    static QString sample(const char* name) {
        return QStringLiteral(COVARIA_SOURCE_DIR "/tests/data/readers/") + QLatin1String(name);
    }
    static void press_import(ImportDialog& dialog) {
        QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                          Qt::LeftButton);
    }
};

TEST_F(FileImportSession, ADroppedBudgetIsShownAndAddedInOneStep) {
    open(project_copy());
    const std::size_t before = window_->document().project().analyses.size();
    ImportDialog* dialog = drop(sample("budget.xlsx"));
    ASSERT_TRUE(dialog);
    auto* preview = dialog->findChild<QPlainTextEdit*>(QStringLiteral("preview"));
    EXPECT_TRUE(preview->toPlainText().contains(QStringLiteral("575 [nm/K]*delta_t")));
    EXPECT_TRUE(preview->toPlainText().contains(QStringLiteral("sheet 'Cover'")));
    EXPECT_EQ(dialog->findChild<QComboBox*>(QStringLiteral("sheet"))->currentText(),
              QStringLiteral("Budget"));
    dialog->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/test-files/import-dialog.png"));
    // A column that is not read makes other numbers: without divisors the file does not say enough.
    auto* divisor = dialog->findChild<QComboBox*>(QStringLiteral("column-6"));
    ASSERT_TRUE(divisor);
    const int as_named = divisor->currentIndex();
    choose_in(*divisor, QStringLiteral("not read"));
    EXPECT_TRUE(
        dialog->findChild<QLabel*>(QStringLiteral("summary"))->text().contains(QStringLiteral("Budget!E4")));
    EXPECT_FALSE(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    divisor->setCurrentIndex(as_named);
    press_import(*dialog);
    const Project& project = window_->document().project();
    ASSERT_EQ(project.analyses.size(), before + 1);
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::analysis, project.analyses.back().id}));
    EXPECT_NE(project.analyses.back().notes.find("budget.xlsx"), std::string::npos);
    EXPECT_NE(project.analyses.back().notes.find("SHA-256"), std::string::npos);
    window_->document().undo_stack().undo();
    EXPECT_EQ(window_->document().project().analyses.size(), before);
}

// A column nobody understands is asked about, a unit nobody knows is typed over, a row is left out: all in
// the dialog, which shows every row.
TEST_F(FileImportSession, ABudgetIsMendedInTheDialog) {
    open(project_copy());
    ImportDialog* dialog = drop(sample("budgets/unknown-unit.xlsx"));
    ASSERT_TRUE(dialog);
    auto* table = dialog->findChild<QTableWidget*>(QStringLiteral("table"));
    auto* summary = dialog->findChild<QLabel*>(QStringLiteral("summary"));
    const auto ok = [&] { return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); };
    EXPECT_EQ(table->rowCount(), 45) << "what each column is, the heads, and all rows";
    EXPECT_FALSE(ok()->isEnabled());
    EXPECT_TRUE(summary->text().contains(QStringLiteral("Xyzzy"))) << summary->text().toStdString();
    auto* unknown = dialog->findChild<QComboBox*>(QStringLiteral("column-5"));
    EXPECT_EQ(unknown->currentText(), QStringLiteral("unknown: choose"));
    choose_in(*unknown, QStringLiteral("not read"));
    EXPECT_TRUE(summary->text().contains(QStringLiteral("B!C3"))) << summary->text().toStdString();
    EXPECT_NE(table->item(3, 2)->background().style(), Qt::NoBrush) << "the row that is wrong is marked";
    EXPECT_EQ(table->item(2, 2)->background().style(), Qt::NoBrush);
    table->setCurrentCell(3, 0);
    auto* leave_out = dialog->findChild<QPushButton*>(QStringLiteral("leave_out"));
    leave_out->click();
    EXPECT_TRUE(ok()->isEnabled()) << summary->text().toStdString();
    leave_out->click();
    EXPECT_FALSE(ok()->isEnabled());
    table->item(3, 2)->setText(QStringLiteral("mm"));
    EXPECT_TRUE(ok()->isEnabled()) << summary->text().toStdString();
    dialog->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/test-files/import-mended.png"));
    press_import(*dialog);
    EXPECT_EQ(window_->document().project().analyses.back().name, "unknown-unit");
}

TEST_F(FileImportSession, UnitsThatTheFileDoesNotStateAreTyped) {
    open(project_copy());
    ImportDialog* dialog = drop(sample("traverse.obs"));
    ASSERT_TRUE(dialog);
    auto* units = dialog->findChild<QTableWidget*>(QStringLiteral("units"));
    ASSERT_EQ(units->rowCount(), 1);
    EXPECT_EQ(units->item(0, 1)->text(), QStringLiteral("gon"));
    const auto ok = [&] { return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); };
    units->item(0, 1)->setText(QStringLiteral("mm"));
    EXPECT_FALSE(ok()->isEnabled());
    units->item(0, 1)->setText(QStringLiteral("degre"));
    EXPECT_FALSE(ok()->isEnabled());
    units->item(0, 1)->setText(QStringLiteral("deg"));
    EXPECT_TRUE(ok()->isEnabled());
    dialog->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/test-files/import-units.png"));
    EXPECT_TRUE(dialog->findChild<QPlainTextEdit*>(QStringLiteral("preview"))
                    ->toPlainText()
                    .contains(QStringLiteral("no unit, ° is taken")));
    dialog->reject();
}

TEST_F(FileImportSession, AFileDroppedOnTheStartPageBeginsAProject) {
    ASSERT_TRUE(action(QStringLiteral("Import File"))->isEnabled());
    ImportDialog* dialog = drop(sample("budget.xlsx"));
    ASSERT_TRUE(dialog);
    EXPECT_FALSE(action(QStringLiteral("Save"))->isEnabled());  // nothing is there until it is accepted
    dialog->reject();
    EXPECT_TRUE(wait_for([&] { return !window_->findChild<ImportDialog*>(QStringLiteral("import")); }));
    EXPECT_FALSE(action(QStringLiteral("Save"))->isEnabled());
    dialog = drop(sample("budget.xlsx"));
    ASSERT_TRUE(dialog);
    press_import(*dialog);
    const Project& project = window_->document().project();
    ASSERT_EQ(project.analyses.size(), 1u);
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::analysis, project.analyses[0].id}));
    EXPECT_TRUE(action(QStringLiteral("Save"))->isEnabled());
    EXPECT_TRUE(window_->document().is_modified());
    window_->document().undo_stack().undo();
    EXPECT_TRUE(window_->document().project().analyses.empty());
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(FileImportSession, ARobotDroppedOnTheStartPageBeginsAProject) {
    const QString file = folder_.filePath(QStringLiteral("arm.urdf"));
    QFile arm(file);
    ASSERT_TRUE(arm.open(QIODevice::WriteOnly));
    arm.write(
        "<robot name=\"Arm\"><joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"l\"/>"
        "<axis xyz=\"0 0 1\"/></joint></robot>");
    arm.close();
    let_go(file);
    const Project& project = window_->document().project();
    ASSERT_EQ(project.assets.size(), 1u);
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::asset, project.assets[0].id}));
    EXPECT_TRUE(action(QStringLiteral("Save"))->isEnabled());
}

TEST_F(FileImportSession, TheWorkbookOfTheWindowIsThatOfTheCommandLine) {
    const QString project = folder_.filePath(QStringLiteral("h1.covaria"));
    ASSERT_TRUE(
        QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"), project));
    open(project);
    window_->runner().run_all();
    wait_until_idle();
    const QString ours = folder_.filePath(QStringLiteral("window.xlsx")),
                  theirs = folder_.filePath(QStringLiteral("line.xlsx"));
    answer_.file_to_save = ours;
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Excel workbook"));
    ASSERT_TRUE(wait_for([&] { return finished.size() == 1; }));
    EXPECT_EQ(finished[0][1].toString().toStdString(), "");
    QProcess program;
    program.start(QStringLiteral(COVARIA_PROGRAM), {QStringLiteral("export"), project, QStringLiteral("--as"),
                                                    QStringLiteral("xlsx"), QStringLiteral("-o"), theirs});
    ASSERT_TRUE(program.waitForFinished(60'000));
    EXPECT_EQ(program.exitCode(), 0);
    QFile a(ours), b(theirs);
    ASSERT_TRUE(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    EXPECT_EQ(a.readAll(), b.readAll());
}

TEST_F(FileImportSession, WhatNobodyRecognisesIsAskedFor) {
    open(project_copy());
    QFile file(folder_.filePath(QStringLiteral("numbers.txt")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("p1 1 2 3 0.1 0.1 0.2\np2 4 5 6 0.1 0.1 0.2\n");
    file.close();
    const std::size_t before = window_->document().project().assets.size();
    answer_.file_to_import = file.fileName();
    trigger(QStringLiteral("Import File"));
    auto* dialog = window_->findChild<ImportDialog*>(QStringLiteral("import"));
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(dialog->findChild<QLabel*>(QStringLiteral("summary"))
                    ->text()
                    .contains(QStringLiteral("six numbers may be")));
    const char* columns[] = {
        "name of the point",        "x", "y", "z", "standard uncertainty of x", "standard uncertainty of y",
        "standard uncertainty of z"};
    for (int i = 0; i < 7; ++i)
        choose_in(*dialog->findChild<QComboBox*>(QStringLiteral("column-%1").arg(i + 1)),
                  QLatin1String(columns[i]));
    EXPECT_TRUE(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled())
        << dialog->findChild<QLabel*>(QStringLiteral("summary"))->text().toStdString();
    press_import(*dialog);
    EXPECT_EQ(window_->document().project().assets.size(), before + 1);
}

}  // namespace
}  // namespace covaria::ui::import_session_test
