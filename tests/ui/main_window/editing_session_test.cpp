// Editing through the real widgets: fields, tables, lists, undo.
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QUndoStack>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/document/project_edits.h"
#include "ui/forms/setup_form.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"

namespace covaria::ui::editing_session_test {
namespace {

using EditingSession = Session;

/// Numbers are read and written as this locale does while it lives.
class LocaleOf {
public:
    explicit LocaleOf(QLocale::Language language) { QLocale::setDefault(QLocale(language)); }
    ~LocaleOf() { QLocale::setDefault(QLocale::c()); }
};

TEST_F(EditingSession, AnEditedUncertaintyChangesTableChartAndScene) {
    open(project_copy());
    wait_until_idle();
    ASSERT_FALSE(window_->selection().analysis().isEmpty());
    const double before = expanded_uncertainty(2);
    const QImage scene_before = scene_picture();
    ASSERT_FALSE(scene_before.isNull());
    const QString cell_before = window_->results().outputs().table().csv();

    type_into("base_u_z", QStringLiteral("1.05 mm"));
    wait_until_idle();
    EXPECT_GT(expanded_uncertainty(2), 2.0 * before);
    EXPECT_NE(window_->results().outputs().table().csv(), cell_before);
    EXPECT_NE(scene_picture(), scene_before);
}

TEST_F(EditingSession, AFourthBasePointIsTypedIn) {
    open(project_copy());
    wait_until_idle();
    const std::size_t inputs_before = status().prepared->inputs.quantities.size();
    ASSERT_EQ(sheet("base_points")->model()->rowCount(), 3);
    press_button("base_points", QStringLiteral("Add row"));
    ASSERT_EQ(sheet("base_points")->model()->rowCount(), 4);
    EXPECT_EQ(sheet("base_points")->currentIndex().row(), 3) << "typing goes on in the new row";
    EXPECT_TRUE(problems().join(QLatin1Char('\n')).contains(QStringLiteral("row 4")))
        << problems().join(QLatin1Char('\n')).toStdString();

    sheet("base_points")->setFocus();
    for (const char* text : {"b4", "0", "-100", "5"}) {
        type_keys(QString::fromLatin1(text));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(cell("base_points", 3, 0), QStringLiteral("b4"));
    EXPECT_EQ(cell("base_points", 3, 2), QStringLiteral("−100"));
    const QString warning = problems().join(QLatin1Char('\n'));
    EXPECT_TRUE(warning.contains(QStringLiteral("b4"))) << warning.toStdString();
    EXPECT_TRUE(warning.contains(QStringLiteral("least squares"))) << warning.toStdString();

    choose("base_fit", QStringLiteral("least squares"));
    wait_until_idle();
    ASSERT_NE(status().prepared, nullptr) << status().message.toStdString();
    EXPECT_EQ(status().prepared->inputs.quantities.size(), inputs_before + 3);
    EXPECT_EQ(status().state, RunState::up_to_date) << status().message.toStdString();
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
}

TEST_F(EditingSession, ATableIsPastedFromAGermanSpreadsheet) {
    const LocaleOf german(QLocale::German);
    open(project_copy());
    select(SetupOwner::analysis, window_->document().project().analyses.front().id);
    paste("poses", 0, 0, QStringLiteral("Pose A\t-120,5\t1e2\t1235\t0\t0\t0,25\r\nPose B\t0,125\t2\t3\r\n"));
    EXPECT_EQ(cell("poses", 0, 0), QStringLiteral("Pose A"));
    EXPECT_EQ(cell("poses", 0, 1), QStringLiteral("−120,5"));
    EXPECT_EQ(cell("poses", 0, 6), QStringLiteral("0,25"));
    EXPECT_EQ(cell("poses", 1, 1), QStringLiteral("0,125"));
    EXPECT_EQ(sheet("poses")->model()->rowCount(), 13);
    paste("poses", 12, 1, QStringLiteral("1\r\n2\r\n3\r\n"));
    EXPECT_EQ(sheet("poses")->model()->rowCount(), 15) << "rows are added as needed";
    EXPECT_EQ(cell("poses", 14, 1), QStringLiteral("3"));
    press("poses", QKeySequence::Undo);
    press("poses", QKeySequence::Undo);
    EXPECT_FALSE(window_->document().is_modified()) << "a paste is one step";
}

// Tab had opened the next cell, whose empty editor kept undo for itself.
TEST_F(EditingSession, AnEditorInWhichNothingWasTypedLeavesUndoToTheProject) {
    open(project_copy());
    select(SetupOwner::analysis, window_->document().project().analyses.front().id);
    paste("poses", 0, 1, QStringLiteral("7\r\n"));
    ASSERT_TRUE(window_->document().is_modified());
    go_to_cell("poses", 0, 2);
    QTest::keyClick(sheet("poses"), Qt::Key_F2);
    auto* editor = sheet("poses")->viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keySequence(editor, QKeySequence::Undo);
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(EditingSession, RowsAreFilledDownInsertedAndDeleted) {
    open(project_copy());
    go_to_cell("poses", 3, 3);
    for (int i = 0; i < 3; ++i) QTest::keyClick(sheet("poses"), Qt::Key_Down, Qt::ShiftModifier);
    press("poses", QKeySequence(Qt::CTRL | Qt::Key_D));
    for (int row = 3; row <= 6; ++row) EXPECT_EQ(cell("poses", row, 3), QStringLiteral("1115")) << row;

    go_to_cell("poses", 0, 0);
    press("poses", QKeySequence(Qt::CTRL | Qt::Key_I));
    EXPECT_EQ(sheet("poses")->model()->rowCount(), 14);
    EXPECT_EQ(cell("poses", 0, 0), QString());
    EXPECT_EQ(cell("poses", 1, 0), QStringLiteral("pose 1"));
    press("poses", QKeySequence(Qt::CTRL | Qt::Key_Minus));
    EXPECT_EQ(sheet("poses")->model()->rowCount(), 13);
    EXPECT_EQ(cell("poses", 0, 0), QStringLiteral("pose 1"));
    for (int i = 0; i < 3; ++i) press("poses", QKeySequence::Undo);
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(EditingSession, UndoWorksWhileTheFieldHasTheFocus) {
    open(project_copy());
    const std::string saved = bytes();
    type_into("base_u_x", QStringLiteral("0.08 mm"));
    ASSERT_NE(bytes(), saved);
    QTest::keySequence(field<QLineEdit>("base_u_x"), QKeySequence::Undo);
    EXPECT_EQ(bytes(), saved);
    EXPECT_EQ(field<QLineEdit>("base_u_x")->text(), QStringLiteral("0.066 mm"));
}

TEST_F(EditingSession, WhatIsBeingTypedIntoACellSurvivesChecksAndRuns) {
    open(project_copy());
    wait_until_idle();
    go_to_cell("poses", 2, 1);
    type_keys(QStringLiteral("12"));
    QWidget* editor = QApplication::focusWidget();
    window_->document().check_now();
    window_->runner().run_all();  // the runner by itself: the user's "Run" takes over typed texts
    wait_until_idle();
    ASSERT_EQ(QApplication::focusWidget(), editor);
    type_keys(QStringLiteral("5"));
    QTest::keyClick(editor, Qt::Key_Tab);
    EXPECT_EQ(cell("poses", 2, 1), QStringLiteral("125"));
}

TEST_F(EditingSession, EscapeTakesBackWhatWasTyped) {
    open(project_copy());
    auto* edit = field<QLineEdit>("base_u_x");
    const QString before = edit->text();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QStringLiteral("12"));
    QTest::keyClick(edit, Qt::Key_Escape);
    EXPECT_EQ(edit->text(), before);
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(EditingSession, TypingANameIsOneStep) {
    open(project_copy());
    show_group(QStringLiteral("Notes"));
    QLineEdit* name = nullptr;
    for (QLineEdit* edit : window_->properties().findChildren<QLineEdit*>())
        if (edit->accessibleName() == QStringLiteral("Name")) name = edit;
    ASSERT_NE(name, nullptr);
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("As printed"));
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_TRUE(names_in_tree().contains(QStringLiteral("As printed")));
    EXPECT_EQ(window_->document().undo_stack().count(), 1);
}

TEST_F(EditingSession, DeletingAnAssetNamesWhatDependsOnIt) {
    open(project_copy());
    click_in_tree(QStringLiteral("2D artefact"));
    QString asked;
    window_->files().dialogs.confirm = [&](const QString& question, const QString&) {
        asked = question;
        return false;
    };
    trigger(QStringLiteral("Delete"));
    const QStringList names = names_in_tree();
    EXPECT_TRUE(asked.contains(QStringLiteral("2D artefact"))) << asked.toStdString();
    const QStringList users = dependants(window_->document().project(), {SetupOwner::asset, "artefact-2d"});
    ASSERT_FALSE(users.isEmpty());
    for (const QString& user : users) EXPECT_TRUE(asked.contains(user)) << asked.toStdString();
    EXPECT_TRUE(names.contains(QStringLiteral("2D artefact"))) << "kept when the question is declined";
    window_->files().dialogs.confirm = [](const QString&, const QString&) { return true; };
    trigger(QStringLiteral("Delete"));
    EXPECT_FALSE(names_in_tree().contains(QStringLiteral("2D artefact")));
    EXPECT_TRUE(problems().join(QLatin1Char('\n')).contains(QStringLiteral("artefact-2d")));
    trigger(QStringLiteral("Undo Delete 2D artefact"));
    settle();
    auto* form = window_->properties().findChild<SetupForm*>();
    ASSERT_NE(form, nullptr) << "it is selected again, and shown";
    EXPECT_EQ(form->address().id, "artefact-2d");
}

TEST_F(EditingSession, AClickOnAProblemGoesToTheField) {
    open(project_copy());
    paste("poses", 4, 0, QStringLiteral("pose 1"));
    ASSERT_EQ(problems().size(), 3);
    select(SetupOwner::asset, window_->document().project().assets.front().id);
    auto* pane = window_->findChild<ProblemsPane*>();
    ASSERT_EQ(pane->model()->rowCount(), 1);
    pane->window()->findChild<QWidget*>(QStringLiteral("problems"))->raise();
    const QModelIndex first = pane->model()->index(0, 1);
    QTest::mouseClick(pane->viewport(), Qt::LeftButton, {}, pane->visualRect(first).center());
    EXPECT_EQ(window_->selection().entry().owner, SetupOwner::analysis);
    EXPECT_EQ(sheet("poses")->currentIndex().row(), 4);
    EXPECT_EQ(sheet("poses")->currentIndex().column(), 0);
    EXPECT_TRUE(sheet("poses")->hasFocus());
}

class MixedEdits : public Session {
protected:
    void edit(int i) {
        const QString number = QString::number(0.07 + 0.001 * i);
        switch (i % 10) {
            case 0:
                return type_into("base_u_x", number + QStringLiteral(" mm"));
            case 1:
                return choose("base_fit",
                              i % 20 == 1 ? QStringLiteral("least squares") : QStringLiteral("3-2-1"));
            case 2:
                return paste("poses", i % 13, 1, number + QStringLiteral("\t1\t2\r\n3\t4\t5\r\n"));
            case 3:
                return press_button("poses", QStringLiteral("Add row"));
            case 4:
                go_to_cell("poses", 2, 0);
                return press("poses", QKeySequence(Qt::CTRL | Qt::Key_Minus));
            case 5:
                return rename_in_tree(QStringLiteral("Renamed %1").arg(i));
            case 6:
                trigger(add_words_);
                return QCoreApplication::processEvents();  // the new form takes the keyboard
            case 7:
                return trigger(QStringLiteral("Duplicate"));
            case 8:
                return trigger(QStringLiteral("Delete"));
            default:
                click_in_tree(QStringLiteral("Renamed %1").arg(i - 4));
                show_group(QStringLiteral("Options"));
                return type_into("trials", QString::number(1000 + i));
        }
    }
    /// Every table and tree that is there is watched while it is edited, proxies too.
    void check_models() {
        for (QAbstractItemView* view : window_->findChildren<QAbstractItemView*>())
            if (qobject_cast<QTableView*>(view) || qobject_cast<QTreeView*>(view))
                new QAbstractItemModelTester(
                    view->model(), QAbstractItemModelTester::FailureReportingMode::Fatal, view->model());
    }
    void rename_in_tree(const QString& name) {
        ProjectPane& tree = window_->project_pane();
        tree.setFocus();
        trigger(QStringLiteral("Rename"));
        auto* editor = tree.viewport()->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();  // the editor closes after its key event
    }
    const QString add_words_ = QStringLiteral("Pose from points");
};

TEST_F(MixedEdits, FiftyUndoneGiveTheSavedBytesAndRedoneTheEditedOnes) {
    const QString file = project_copy();
    open(file);
    const std::string saved = bytes();
    QUndoStack& stack = window_->document().undo_stack();
    check_models();
    for (int i = 0; i < 50; ++i) {
        const int steps = stack.count();
        ASSERT_NO_FATAL_FAILURE(edit(i)) << i;
        EXPECT_EQ(stack.count(), steps + 1) << "edit " << i << " is one step";
        window_->document().end_merging();
    }
    const std::string edited = bytes();
    EXPECT_NE(edited, saved);
    for (int i = 0; i < 50; ++i) QTest::keySequence(window_.get(), QKeySequence::Undo);
    EXPECT_EQ(bytes(), saved);
    QFile on_disk(file);
    ASSERT_TRUE(on_disk.open(QIODevice::ReadOnly));
    EXPECT_EQ(on_disk.readAll().toStdString(), saved);
    EXPECT_FALSE(window_->document().is_modified());
    for (int i = 0; i < 50; ++i) QTest::keySequence(window_.get(), QKeySequence(Qt::CTRL | Qt::Key_Y));
    EXPECT_EQ(bytes(), edited);
}

}  // namespace
}  // namespace covaria::ui::editing_session_test
