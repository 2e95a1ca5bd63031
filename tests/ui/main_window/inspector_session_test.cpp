// The inspector: groups that fold and answer while they are folded, and the way from entry to entry; what is
// wrong in a field leaves the last answer in sight.
#include <QGraphicsOpacityEffect>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/pages/answer_strip.h"
#include "ui/pages/recent_card.h"
#include "ui/pages/run_status.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui::inspector_session_test {
namespace {

class InspectorSession : public Session {
protected:
    FoldGroups& groups() { return window_->properties().groups(); }
    FoldHead* head(const QString& title) {
        for (int i = 0; i < groups().count(); ++i)
            if (groups().title(i) == title) return groups().head(i);
        return nullptr;
    }
    QToolButton* step(const QString& name) {
        for (auto* button : window_->findChildren<QToolButton*>())
            if (button->accessibleName() == name) return button;
        return nullptr;
    }
};

TEST_F(InspectorSession, AGroupFoldsAndAnswersWhileItIsFolded) {
    open(project_copy());
    wait_until_idle();
    FoldHead* options = head(QStringLiteral("Options"));
    ASSERT_NE(options, nullptr);
    EXPECT_FALSE(options->isChecked());
    const auto* trials = window_->properties().findChild<QLineEdit*>(QStringLiteral("trials"));
    ASSERT_NE(trials, nullptr);
    EXPECT_FALSE(trials->isVisible());
    EXPECT_TRUE(options->summary().contains(QStringLiteral("Monte Carlo")))
        << options->summary().toStdString();
    EXPECT_EQ(head(QStringLiteral("Studies"))->summary(),
              window_->document().project().analyses.front().studies.empty() ? QStringLiteral("none")
                                                                             : QStringLiteral("1"));
    QTest::mouseClick(options, Qt::LeftButton);
    EXPECT_TRUE(wait_for([&] { return trials->isVisible(); }));
    // A group stays as the user left it, also when other entries are selected.
    const SetupAddress entry = window_->selection().entry();
    select(SetupOwner::asset, window_->document().project().assets.front().id);
    window_->selection().select_entry(entry);
    EXPECT_TRUE(head(QStringLiteral("Options"))->isChecked());
    QTest::mouseClick(head(QStringLiteral("Options")), Qt::LeftButton);
    EXPECT_FALSE(head(QStringLiteral("Options"))->isChecked());
}

TEST_F(InspectorSession, AHeadIsOpenedByTheKeyboard) {
    open(project_copy());
    wait_until_idle();
    FoldHead* notes = head(QStringLiteral("Notes"));
    notes->setFocus(Qt::TabFocusReason);
    QTest::keyClick(notes, Qt::Key_Space);
    EXPECT_TRUE(notes->isChecked());
    QTest::keyClick(notes, Qt::Key_Space);
    EXPECT_FALSE(notes->isChecked());
}

TEST_F(InspectorSession, TheTitleLeadsToTheEntryBeforeAndAfter) {
    open(project_copy());
    wait_until_idle();
    const Project& project = window_->document().project();
    select(SetupOwner::analysis, project.analyses.front().id);
    QToolButton* before = step(QStringLiteral("Entry before"));
    ASSERT_NE(before, nullptr);
    QTest::mouseClick(before, Qt::LeftButton);
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::asset, project.assets.back().id}));
    QTest::mouseClick(step(QStringLiteral("Entry after")), Qt::LeftButton);
    EXPECT_EQ(window_->selection().entry(),
              (SetupAddress{SetupOwner::analysis, project.analyses.front().id}));
}

TEST_F(InspectorSession, AWrongFieldLeavesTheLastAnswerFaintWithTheWayToTheField) {
    open(project_copy());
    wait_until_idle();
    auto& answer = window_->results().answer();
    const QString before = to_qt(to_unicode(answer.value().text()));
    ASSERT_FALSE(before.isEmpty());
    EXPECT_EQ(answer.value().graphicsEffect(), nullptr);
    type_into("base_u_x", QStringLiteral("12 kg"));
    ASSERT_TRUE(wait_for([&] { return answer.value().graphicsEffect() != nullptr; }));
    EXPECT_EQ(to_qt(to_unicode(answer.value().text())), before);
    EXPECT_FALSE(scene_picture().isNull());
    EXPECT_TRUE(window_->scene().view().property(is_faint).toBool());
    ASSERT_TRUE(answer.next_step().isVisible());
    select(SetupOwner::asset, window_->document().project().assets.front().id);
    QTest::mouseClick(&answer.next_step(), Qt::LeftButton);
    EXPECT_TRUE(wait_for([&] { return field<QLineEdit>("base_u_x")->hasFocus(); }));
    type_into("base_u_x", QStringLiteral("0.066 mm"));
    EXPECT_TRUE(wait_for([&] { return answer.value().graphicsEffect() == nullptr; }));
    EXPECT_TRUE(wait_for([&] { return !window_->scene().view().property(is_faint).toBool(); }));
}

TEST_F(InspectorSession, UndoGoesToTheEntryWhereTheStepWas) {
    open(project_copy());
    wait_until_idle();
    const SetupAddress edited = window_->selection().entry();
    type_into("base_u_x", QStringLiteral("0.123 mm"));
    select(SetupOwner::asset, window_->document().project().assets.front().id);
    for (QAction* undo : window_->findChildren<QAction*>())
        if (plain_words(undo->text()).startsWith(QStringLiteral("Undo Change"))) {
            undo->trigger();
            break;
        }
    EXPECT_EQ(window_->selection().entry(), edited);
}

TEST_F(InspectorSession, SavingMakesNoStep) {
    open(project_copy());
    wait_until_idle();
    type_into("base_u_x", QStringLiteral("0.123 mm"));
    const int steps = window_->document().undo_stack().count();
    trigger(QStringLiteral("Save"));
    EXPECT_EQ(window_->document().undo_stack().count(), steps);
    EXPECT_EQ(window_->document().undo_stack().index(), steps);
}

TEST_F(InspectorSession, TheStartPageShowsAnswerAndPictureOfARecentProject) {
    const QString file = project_copy();
    open(file);
    wait_until_idle();
    ASSERT_FALSE(scene_picture().isNull());
    RecentFacts kept;
    EXPECT_TRUE(wait_for([&] { return !(kept = recent_facts(file)).picture.isNull(); }, 10'000));
    EXPECT_EQ(kept.answer, to_qt(to_unicode(window_->results().answer().value().text())));
    EXPECT_EQ(kept.title, to_qt(window_->document().project().title));
    const auto cards = window_->findChildren<RecentCard*>();
    ASSERT_FALSE(cards.isEmpty());
    EXPECT_TRUE(std::ranges::any_of(
        cards, [&](const RecentCard* card) { return card->facts().answer == kept.answer; }));
}

TEST(TimeLeft, IsSaidAsPeopleDo) {
    EXPECT_EQ(time_left_words(3.2), QStringLiteral("4 s left"));
    EXPECT_EQ(time_left_words(530.0), QStringLiteral("9 min left"));
    EXPECT_EQ(time_left_words(9000.0), QStringLiteral("2.5 h left"));
}

}  // namespace
}  // namespace covaria::ui::inspector_session_test
