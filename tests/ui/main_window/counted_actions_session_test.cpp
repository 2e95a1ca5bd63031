// How many actions a user needs for what is done most: each click, each text typed and each key that is none
// of a text is one.
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "core/project/stated_requirements.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/target_box.h"
#include "ui/pages/asset_uses.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/library_browser.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/question_tile.h"
#include "ui/pages/stage.h"
#include "ui/pages/study_tab.h"

namespace covaria::ui::counted_actions_session_test {
namespace {

class CountedActions : public Session {
protected:
    void count() { ++actions_; }
    void click(QWidget* widget) {
        ASSERT_NE(widget, nullptr);
        settle();
        ASSERT_TRUE(widget->isVisible() && widget->isEnabled()) << to_std(widget->objectName());
        QTest::mouseClick(widget, Qt::LeftButton);
        count();
    }
    void click_on_button(QWidget& in, const char* name) {
        click(in.findChild<QWidget*>(QString::fromLatin1(name)));
    }
    void show(QWidget& view) {
        window_->results().stage().show_view(&view);
        count();
    }
    static QPushButton* button_called(const QWidget& in, const QString& words) {
        for (QPushButton* button : in.findChildren<QPushButton*>())
            if (button->text() == words) return button;
        return nullptr;
    }
    QToolButton* use_called(const QString& words) const {
        const auto* uses = window_->properties().findChild<AssetUses*>();
        for (QToolButton* button : uses ? uses->findChildren<QToolButton*>() : QList<QToolButton*>())
            if (button->text() == words) return button;
        return nullptr;
    }
    std::size_t not_met() const {
        const auto verdicts =
            judge(*status().result, window_->document().project(), to_std(window_->selection().analysis()));
        return static_cast<std::size_t>(std::ranges::count_if(
            verdicts, [](const RequirementResult& verdict) { return !is_met(verdict); }));
    }

    int actions_ = 0;
};

// From the library to where the arm is good and where it is not.
TEST_F(CountedActions, ARobotFromTheLibraryToItsMap) {
    trigger(QStringLiteral("Library and Examples"));
    count();
    LibraryBrowser& library = window_->library();
    QTest::keyClicks(&library.search(), QStringLiteral("irb 1600"));
    count();
    QTest::keyClick(&library.search(), Qt::Key_Return);
    count();
    library.close();
    count();
    settle();
    QApplication::setActiveWindow(window_.get());
    ASSERT_TRUE(wait_for([this] { return QApplication::activeWindow() == window_.get(); }));
    sheet("uncertainties");  // opens its group
    count();
    paste("uncertainties", 0, 0, QStringLiteral("as built\t\t0.01\t0.1\t0.1\t0.01\t\t"));
    count();
    EXPECT_TRUE(problems().isEmpty()) << to_std(problems().join(QLatin1Char('\n')));
    ASSERT_TRUE(wait_for([this] { return use_called(QStringLiteral("Tool position of a robot")); }));
    click(use_called(QStringLiteral("Tool position of a robot")));
    ASSERT_TRUE(wait_for([this] { return status().result && status().is_current(); }));
    EXPECT_EQ(window_->document().project().assets.size(), 1U) << "it is the robot that was added";
    EXPECT_GT(expanded_uncertainty(0), 0.0);
    StudyTab& tab = window_->results().study_tab();
    show(tab);
    click(button_called(tab, QStringLiteral("Add Study …")));
    click(button_called(tab, QStringLiteral("Run Study")));
    ASSERT_TRUE(wait_for([this] {
        return window_->runner()
            .studies()
            .status(window_->selection().analysis(), window_->selection().study())
            .is_current();
    }));
    EXPECT_EQ(tab.chart().plot().series.at(0).kind, SeriesKind::heat_map);
    EXPECT_TRUE(wait_for([this] {
        const auto scene = window_->scene().view().scene();
        return scene && scene->map && !window_->scene().is_building();
    }));
    keep_picture(QStringLiteral("counted-robot"));
    RecordProperty("actions", actions_);
    EXPECT_LE(actions_, 12);
}

// The pose of a platform seen by a tracker, what is required of it, and a better place for the tracker.
TEST_F(CountedActions, APoseWithARequirementAndADesignTakenOver) {
    QuestionTile* tile = nullptr;
    for (QuestionTile* one : window_->findChildren<QuestionTile*>())
        if (one->text() == QStringLiteral("The pose of an object")) tile = one;
    ASSERT_NE(tile, nullptr);
    count();  // the click that opens its menu
    tile->menu().actions().constFirst()->trigger();
    count();
    ASSERT_TRUE(wait_for([this] { return status().result && status().is_current(); }));
    OutputsTab& outputs = window_->results().outputs();
    show(outputs);
    SortableTable& view = outputs.table();
    view.setFocus();
    view.selectAll();
    count();
    const auto column = [&](const QString& head) {
        for (int c = 0; c < view.model()->columnCount(); ++c)
            if (view.model()->headerData(c, Qt::Horizontal).toString() == head) return c;
        return -1;
    };
    ASSERT_GE(column(QStringLiteral("Target")), 0);
    view.selectionModel()->setCurrentIndex(view.model()->index(0, column(QStringLiteral("Target"))),
                                           QItemSelectionModel::NoUpdate);
    QTest::keyClick(view.viewport(), Qt::Key_F2);
    count();  // a click into the cell
    auto* editor = view.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, QStringLiteral("60 um"));
    QTest::keyClick(editor, Qt::Key_Return);
    count();
    settle();
    ASSERT_EQ(window_->document().project().analyses.front().requirements.size(), 3U) << "x, y and z";
    const double before = expanded_uncertainty(0);
    DesignTab& tab = window_->results().design_tab();
    show(tab);
    click_on_button(tab, "edit_design");
    type_into("variable_0_from", QStringLiteral("-2 m"));
    count();
    type_into("variable_0_to", QStringLiteral("2 m"));
    count();
    click_on_button(tab, "run_design_tab");
    ASSERT_TRUE(wait_for([this] {
        return window_->runner()
            .designs()
            .status(window_->selection().analysis(), window_->selection().design())
            .is_current();
    }));
    click_on_button(tab, "take_over_design");
    EXPECT_TRUE(wait_for(
        [&] { return status().result && status().is_current() && expanded_uncertainty(0) != before; }));
    keep_picture(QStringLiteral("counted-pose"));
    RecordProperty("actions", actions_);
    EXPECT_LE(actions_, 24);
}

}  // namespace
}  // namespace covaria::ui::counted_actions_session_test
