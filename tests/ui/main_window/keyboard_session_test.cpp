// The window with the keyboard alone: from pane to pane, into tables and out of them, to what was added.
#include <QClipboard>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/forms/lines_editor.h"
#include "ui/main_window/help_actions.h"
#include "ui/pages/budget_page.h"
#include "ui/pages/help_pane.h"
#include "ui/pages/results_pane.h"

namespace covaria::ui::keyboard_session_test {
namespace {

class KeyboardSession : public Session {
protected:
    bool is_in(const QWidget& pane) const {
        const QWidget* focused = QApplication::focusWidget();
        return focused && (focused == &pane || pane.isAncestorOf(focused));
    }
    QString pane_with_focus() const {
        if (is_in(window_->project_pane())) return QStringLiteral("project");
        if (is_in(window_->scene())) return QStringLiteral("scene");
        if (is_in(window_->results())) return QStringLiteral("results");
        if (is_in(window_->properties())) return QStringLiteral("properties");
        return QStringLiteral("none");
    }
    static void press_keys(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QWidget* focused = QApplication::focusWidget();
        ASSERT_NE(focused, nullptr);
        QTest::keyClick(focused, key, modifiers);
        QCoreApplication::processEvents();
    }
    void open_h1() {
        const QString file = folder_.filePath(QStringLiteral("h1.covaria"));
        ASSERT_TRUE(
            QFile::copy(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"), file));
        open(file);
        wait_until_idle();
    }
    void add_equation() {
        trigger(QStringLiteral("New Project"));
        trigger(QStringLiteral("Measurement equation"));
    }
};

TEST_F(KeyboardSession, F6GoesThroughAllPanesAndBack) {
    open(project_copy());
    wait_until_idle();
    window_->project_pane().setFocus();
    QStringList visited;
    for (int i = 0; i < 4; ++i) {
        press_keys(Qt::Key_F6);
        visited << pane_with_focus();
    }
    EXPECT_EQ(visited.join(' ').toStdString(), "scene results properties project");
    visited.clear();
    for (int i = 0; i < 4; ++i) {
        press_keys(Qt::Key_F6, Qt::ShiftModifier);
        visited << pane_with_focus();
    }
    EXPECT_EQ(visited.join(' ').toStdString(), "properties results scene project");
}

TEST_F(KeyboardSession, F11LeavesTheMiddleAloneAndBringsThePanesBack) {
    open(project_copy());
    wait_until_idle();
    const int tree = window_->project_pane().width(), scene = window_->scene().width();
    press_keys(Qt::Key_F11);
    EXPECT_FALSE(window_->project_pane().isVisible());
    EXPECT_FALSE(window_->properties().isVisible());
    EXPECT_TRUE(window_->results().isVisible()) << "the stage stays";
    EXPECT_GT(window_->scene().width(), window_->width() - 20);
    press_keys(Qt::Key_F11);
    EXPECT_TRUE(window_->properties().isVisible());
    EXPECT_EQ(window_->project_pane().width(), tree);
    EXPECT_EQ(window_->scene().width(), scene);

    // A pane that is shown ends it, and what it had put away is not forced back.
    press_keys(Qt::Key_F11);
    trigger(QStringLiteral("Properties"));
    EXPECT_TRUE(window_->properties().isVisible());
    EXPECT_FALSE(window_->project_pane().isVisible());
    press_keys(Qt::Key_F11);
    EXPECT_FALSE(window_->properties().isVisible());
}

TEST_F(KeyboardSession, WhatIsAddedTakesTheKeyboard) {
    add_equation();
    auto* equations = window_->properties().findChild<QPlainTextEdit*>(QStringLiteral("equations"));
    ASSERT_NE(equations, nullptr);
    EXPECT_TRUE(wait_for([&] { return equations->hasFocus(); }, 2000));
}

TEST_F(KeyboardSession, TabLeavesATableBehindItsLastCellAndCtrlTabAtOnce) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    auto* table = sheet("base_points");
    const QAbstractItemModel& cells = *table->model();
    table->setFocus();
    table->setCurrentIndex(cells.index(0, 0));
    press_keys(Qt::Key_Tab);
    EXPECT_EQ(table->currentIndex(), cells.index(0, 1));
    table->setCurrentIndex(cells.index(cells.rowCount() - 1, cells.columnCount() - 1));
    press_keys(Qt::Key_Tab);
    EXPECT_FALSE(table->hasFocus());
    table->setFocus();
    table->setCurrentIndex(cells.index(0, 0));
    press_keys(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_FALSE(table->hasFocus());
    table->setFocus();
    table->setCurrentIndex(cells.index(1, 1));
    press_keys(Qt::Key_Tab, Qt::ControlModifier);
    EXPECT_FALSE(table->hasFocus());
    EXPECT_EQ(table->currentIndex(), cells.index(1, 1));
}

TEST_F(KeyboardSession, CtrlTabLeavesABudgetThatIsScrolled) {
    open_h1();
    auto* budget = window_->scene().findChild<BudgetSheetView*>();
    ASSERT_NE(budget, nullptr);
    window_->resize(900, 700);
    budget->setFocus();
    ASSERT_TRUE(wait_for([&] { return budget->hasFocus(); }, 2000));
    budget->setCurrentIndex(budget->model()->index(0, 1));
    budget->horizontalScrollBar()->setValue(budget->horizontalScrollBar()->maximum());
    ASSERT_GT(budget->horizontalScrollBar()->value(), 0) << "with a frozen column above it";
    press_keys(Qt::Key_Tab, Qt::ControlModifier);
    EXPECT_FALSE(budget->hasFocus());
    EXPECT_NE(QApplication::focusWidget(), nullptr);
}

TEST_F(KeyboardSession, CtrlTabComesFromTwoRowsToTheirCorrelation) {
    open_h1();
    auto* budget = window_->scene().findChild<BudgetSheetView*>();
    ASSERT_NE(budget, nullptr);
    QLineEdit& correlation = window_->budget().correlation();
    budget->setFocus();
    budget->setCurrentIndex(budget->model()->index(0, 0));
    press_keys(Qt::Key_Down, Qt::ShiftModifier);
    ASSERT_TRUE(wait_for([&] { return correlation.isEnabled(); }));
    press_keys(Qt::Key_Tab, Qt::ControlModifier);
    EXPECT_TRUE(correlation.hasFocus()) << QApplication::focusWidget()->objectName().toStdString();
}

TEST_F(KeyboardSession, ATabThatIsClickedHasTheKeyboard) {
    open_h1();
    window_->project_pane().setFocus();
    QTabBar& tabs = *window_->results().tabs().tabBar();
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(1).center());
    EXPECT_EQ(pane_with_focus().toStdString(), "results");
    press_keys(Qt::Key_Right);
    EXPECT_EQ(tabs.currentIndex(), 2);
}

/// The copy has the heads, and no row for new ones; pasted back it is the same budget.
TEST_F(KeyboardSession, AWholeBudgetIsCopiedWithItsHeads) {
    open_h1();
    auto* budget = window_->scene().findChild<BudgetSheetView*>();
    ASSERT_NE(budget, nullptr);
    budget->setFocus();
    ASSERT_TRUE(wait_for([&] { return budget->hasFocus(); }, 2000));
    const int rows = budget->model()->rowCount();
    press_keys(Qt::Key_A, Qt::ControlModifier);
    press_keys(Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), rows) << "heads, and all rows but the one for new ones";
    EXPECT_TRUE(lines.front().startsWith(budget->model()->headerData(0, Qt::Horizontal).toString() +
                                         QLatin1Char('\t')));
    budget->setCurrentIndex(budget->model()->index(0, 0));
    press_keys(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(budget->model()->rowCount(), rows);
    EXPECT_EQ(budget->model()->index(0, 0).data(Qt::EditRole).toString(), lines[1].section('\t', 0, 0));
}

/// Only keys are used after the analysis has been added.
TEST_F(KeyboardSession, ABudgetAndItsCorrelationAreTyped) {
    add_equation();
    auto* equations = window_->properties().findChild<QPlainTextEdit*>(QStringLiteral("equations"));
    ASSERT_TRUE(wait_for([&] { return equations->hasFocus(); }, 2000));
    press_keys(Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(equations, QStringLiteral("L = a + b"));
    press_keys(Qt::Key_F6, Qt::ShiftModifier);
    press_keys(Qt::Key_F6, Qt::ShiftModifier);
    auto* budget = window_->scene().findChild<BudgetSheetView*>();
    ASSERT_NE(budget, nullptr);
    ASSERT_TRUE(wait_for([&] { return budget->hasFocus(); }, 2000)) << pane_with_focus().toStdString();
    budget->setCurrentIndex(budget->model()->index(0, 2));
    for (const char* estimate : {"50 mm", "2 mm"}) {
        const int row = budget->currentIndex().row();
        type_keys(QString::fromLatin1(estimate));
        press_keys(Qt::Key_Return);
        EXPECT_EQ(budget->currentIndex().row(), row + 1);
    }
    budget->setCurrentIndex(budget->model()->index(0, 4));
    for (int row = 0; row < 2; ++row) {
        type_keys(QStringLiteral("1 um"));
        press_keys(Qt::Key_Return);
    }
    ASSERT_TRUE(wait_for([this] { return status().result && status().is_current(); }));
    const double alone = expanded_uncertainty(0);
    budget->setCurrentIndex(budget->model()->index(0, 2));
    press_keys(Qt::Key_Down, Qt::ShiftModifier);
    press_keys(Qt::Key_R, Qt::ControlModifier);
    type_keys(QStringLiteral("0.5"));
    press_keys(Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return status().is_current() && expanded_uncertainty(0) > 1.1 * alone; }))
        << "u of the sum grows by the root of 1.5";
}

TEST_F(KeyboardSession, HelpIsReadAndLeft) {
    open(project_copy());
    wait_until_idle();
    window_->project_pane().setFocus();
    trigger(QStringLiteral("Keys"));
    EXPECT_TRUE(wait_for([&] { return is_in(window_->help().pane()); }, 2000));
    press_keys(Qt::Key_Escape);
    EXPECT_FALSE(window_->help().pane().isVisible());
    EXPECT_EQ(pane_with_focus().toStdString(), "project");
}

}  // namespace
}  // namespace covaria::ui::keyboard_session_test
