// A newcomer goes through the first steps: every step can be shown, sees that it was done, and blocks
// nothing.
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>

#include "core/base/file_io.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/main_window/export_actions.h"
#include "ui/main_window/first_steps_guide.h"
#include "ui/pages/budget_page.h"
#include "ui/pages/first_steps_panel.h"
#include "ui/pages/highlight_frame.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/page_view.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/stage.h"

namespace covaria::ui::first_steps_session_test {
namespace {

using Section = BudgetSheetModel::Section;

class FirstStepsSession : public Session {
protected:
    FirstStepsPanel& panel() const { return window_->first_steps().panel(); }
    QString words(const char* label) const {
        return panel().findChild<QLabel*>(QLatin1String(label))->text();
    }
    void press_button_of_panel(const char* name) {
        auto* found = panel().findChild<QPushButton*>(QLatin1String(name));
        ASSERT_NE(found, nullptr) << name;
        ASSERT_TRUE(found->isEnabled()) << name;
        QTest::mouseClick(found, Qt::LeftButton);
    }
    /// The frame is around what a step means, and what it means can be seen.
    void expect_framed(int step) {
        auto* frame = window_->findChild<HighlightFrame*>();
        ASSERT_NE(frame, nullptr);
        const char* name = first_steps()[std::size_t(step)].target;
        const auto is_framed = [&] {
            return frame->isVisible() && frame->target() &&
                   frame->target()->objectName() == QLatin1String(name);
        };
        ASSERT_TRUE(wait_for(is_framed, 5000)) << name;
        const QWidget* target = frame->target();
        const auto is_seen = [&] {
            const QWidget* there = window_->childAt(frame->geometry().center());
            return there == target || target->isAncestorOf(there);
        };
        EXPECT_TRUE(wait_for(is_seen, 5000)) << name << " is not where the frame is";
    }
    void show_and_go_on(int step) {
        ASSERT_EQ(panel().step(), step);
        EXPECT_EQ(words("step_progress"), QStringLiteral("%1 of 10").arg(step + 1));
        press_button_of_panel("step_show");
        expect_framed(step);
        keep_picture(QStringLiteral("first-steps-%1").arg(step + 1));
        EXPECT_EQ(words("step_remark"), QString());
    }
    void expect_done(int step) {
        EXPECT_TRUE(wait_for([&] { return panel().is_done(step); }, 60'000)) << "step " << step + 1;
        EXPECT_EQ(words("step_state"), QStringLiteral("done"));
        if (step + 1 < int(first_steps().size())) press_button_of_panel("step_next");
    }
    void type_cell(int row, Section section, const QString& text) {
        BudgetSheetView* sheet = window_->budget().view();
        sheet->setFocus();
        sheet->selectionModel()->setCurrentIndex(window_->budget().model()->index(row, section),
                                                 QItemSelectionModel::ClearAndSelect);
        QTest::keyClick(sheet, Qt::Key_F2);
        QWidget* line = QApplication::focusWidget();
        ASSERT_NE(line, sheet);
        QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Tab);
    }
};

TEST_F(FirstStepsSession, StartPageAndMenuBeginThem) {
    auto* start = window_->findChild<QPushButton*>(QStringLiteral("first_steps"));
    ASSERT_NE(start, nullptr);
    QTest::mouseClick(start, Qt::LeftButton);
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("first_steps_dock"));
    ASSERT_NE(dock, nullptr);
    EXPECT_TRUE(dock->isVisible());
    EXPECT_TRUE(window_->document().project().analyses.empty());
    press_button_of_panel("step_next");
    EXPECT_EQ(panel().step(), 1) << "a step that was not done blocks nothing";
    press_button_of_panel("step_close");
    EXPECT_FALSE(dock->isVisible());
    open(project_copy());
    const std::string before = bytes();
    trigger(QStringLiteral("First Steps"));
    EXPECT_TRUE(dock->isVisible());
    EXPECT_EQ(bytes(), before) << "the project that is open stays";
    EXPECT_EQ(panel().step(), 0) << "of another project nothing is done yet";
    EXPECT_FALSE(panel().is_done(0)) << "no budget is typed in it";
}

TEST_F(FirstStepsSession, EveryStepCanBeShownInAFreshProject) {
    trigger(QStringLiteral("First Steps"));
    QApplication::setActiveWindow(window_.get());
    auto* frame = window_->findChild<HighlightFrame*>();
    for (int step = 0; step < int(first_steps().size()); ++step) {
        frame->surround(nullptr);
        window_->first_steps().show_step(step);
        ASSERT_TRUE(wait_for([&] { return frame->isVisible(); }, 5000)) << step;
    }
    frame->surround(nullptr);
    window_->first_steps().show_step(4);
    expect_framed(0);
    EXPECT_TRUE(words("step_remark").contains(QStringLiteral("Add an analysis")))
        << words("step_remark").toStdString();
    trigger(QStringLiteral("Measurement equation"));
    for (int step = 0; step < int(first_steps().size()); ++step) {
        const FirstStep& shown = first_steps()[std::size_t(step)];
        EXPECT_EQ(window_->findChildren<QWidget*>(QLatin1String(shown.target)).size(), 1) << shown.target;
        frame->surround(nullptr);
        window_->first_steps().show_step(step);
        expect_framed(step);
        EXPECT_EQ(words("step_remark"), QString()) << shown.target;
    }
    EXPECT_EQ(window_->document().project().analyses.size(), 1U) << "showing changes nothing";
}

TEST_F(FirstStepsSession, TheHelpPageHasTheSameWords) {
    const auto text = read_file(COVARIA_SOURCE_DIR "/resources/help/first-steps.md");
    ASSERT_TRUE(text);
    std::size_t at = 0;
    for (const FirstStep& step : first_steps()) {
        at = text->find(step.title, at);
        ASSERT_NE(at, std::string::npos) << step.title;
        EXPECT_EQ(text->find(step.text, at), at + std::string(step.title).size() + 2) << step.title;
    }
}

TEST_F(FirstStepsSession, FromNothingToAPdfInTenSteps) {
    trigger(QStringLiteral("First Steps"));
    QApplication::setActiveWindow(window_.get());
    for (int step = 0; step < int(first_steps().size()); ++step) EXPECT_FALSE(panel().is_done(step)) << step;
    show_and_go_on(0);
    trigger(QStringLiteral("Measurement equation"));
    expect_done(0);

    show_and_go_on(1);
    auto* equation = qobject_cast<QPlainTextEdit*>(QApplication::focusWidget());
    ASSERT_NE(equation, nullptr) << "it has the focus";
    QTest::keyClick(equation, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(equation, QStringLiteral("l = l_S + d"));
    QTest::keyClick(equation, Qt::Key_Tab);
    expect_done(1);

    show_and_go_on(2);
    EXPECT_EQ(QApplication::focusWidget(), window_->budget().view());
    type_cell(0, Section::estimate, QStringLiteral("50 mm"));
    type_cell(0, Section::stated, QStringLiteral("75 nm"));
    EXPECT_TRUE(wait_for([&] { return panel().is_done(2); }));
    type_cell(1, Section::estimate, QStringLiteral("215 nm"));
    type_cell(1, Section::stated, QStringLiteral("rect 30 nm"));
    expect_done(2);

    show_and_go_on(3);
    expect_done(3);

    show_and_go_on(4);
    QItemSelectionModel& rows = *window_->budget().view()->selectionModel();
    rows.select(window_->budget().model()->index(0, 0), QItemSelectionModel::ClearAndSelect);
    rows.select(window_->budget().model()->index(1, 0), QItemSelectionModel::Select);
    QLineEdit& r = window_->budget().correlation();
    ASSERT_TRUE(wait_for([&] { return r.isEnabled(); }));
    r.setFocus();
    QTest::keyClicks(&r, QStringLiteral("0.5"));
    QTest::keyClick(&r, Qt::Key_Return);
    expect_done(4);

    show_and_go_on(5);
    auto* target = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_NE(target, nullptr);
    QTest::keyClicks(target, QStringLiteral("200 nm"));
    QTest::keyClick(target, Qt::Key_Return);
    expect_done(5);

    EXPECT_FALSE(panel().is_done(6));
    show_and_go_on(6);
    expect_done(6);

    show_and_go_on(7);
    trigger(QStringLiteral("Run All"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }, 60'000));
    trigger(QStringLiteral("Keep as Before"));
    expect_done(7);

    show_and_go_on(8);
    ASSERT_TRUE(wait_for([this] { return window_->results().report().page_count() > 0; }, 120'000));
    expect_done(8);

    show_and_go_on(9);
    answer_.file_to_save = folder_.filePath(QStringLiteral("first.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Report as PDF"));
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    expect_done(9);
    EXPECT_FALSE(panel().findChild<QPushButton*>(QStringLiteral("step_next"))->isEnabled());
    keep_picture(QStringLiteral("first-steps-done"));
    press_button_of_panel("step_back");
    EXPECT_TRUE(panel().is_done(8)) << "what was done stays done";
    window_->files().new_project();
    EXPECT_FALSE(panel().is_done(9));
    EXPECT_EQ(panel().step(), 0);
}

TEST_F(FirstStepsSession, TheKeyboardIsEnough) {
    trigger(QStringLiteral("First Steps"));
    trigger(QStringLiteral("Measurement equation"));
    QApplication::setActiveWindow(window_.get());
    auto* show = panel().findChild<QPushButton*>(QStringLiteral("step_show"));
    auto* next = panel().findChild<QPushButton*>(QStringLiteral("step_next"));
    show->setFocus();
    QTest::keyClick(show, Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), next) << "Back has nowhere to go";
    for (int step = 0; step + 1 < int(first_steps().size()); ++step) QTest::keyClick(next, Qt::Key_Space);
    EXPECT_EQ(panel().step(), 9);
    EXPECT_EQ(QApplication::focusWidget()->objectName(), QStringLiteral("step_back"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_EQ(panel().step(), 8);
    auto* frame = window_->findChild<HighlightFrame*>();
    show->setFocus();
    QTest::keyClick(show, Qt::Key_Space);
    ASSERT_TRUE(wait_for([&] { return frame->isVisible(); }));
    window_->results().stage().show_view(&window_->results().outputs());
    EXPECT_TRUE(wait_for([&] { return !frame->isVisible(); })) << "what it is about is not in view";
    window_->results().stage().show_view(&window_->results().report());
    EXPECT_TRUE(wait_for([&] { return frame->isVisible(); }));
    panel().findChild<QPushButton*>(QStringLiteral("step_close"))->click();
    EXPECT_TRUE(wait_for([&] { return !frame->isVisible(); })) << "no frame without the panel";
}

}  // namespace
}  // namespace covaria::ui::first_steps_session_test
