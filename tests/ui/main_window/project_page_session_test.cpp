// A user fills in the page of the project; the window, reports and files follow, in one step that can be
// undone.
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMenu>
#include <QWheelEvent>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/models/roles.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"
#include "ui/pages/unit_button.h"

namespace covaria::ui::project_page_session_test {
namespace {

class ProjectPageSession : public Session {
protected:
    QString cell_of(const char* head) {
        const QAbstractItemModel& table = *window_->results().outputs().table().model();
        for (int c = 0; c < table.columnCount(); ++c)
            if (table.headerData(c, Qt::Horizontal, id_role).toString() == QLatin1String(head))
                return table.index(0, c).data().toString();
        return {};
    }
};

TEST_F(ProjectPageSession, WhatTheProjectStatesIsObeyedAndUndone) {
    open(project_copy());
    const std::string before = bytes();
    window_->document().apply(QStringLiteral("k from nu"), [](Project& project) {
        for (AnalysisEntry& analysis : project.analyses) analysis.options.coverage_factor.reset();
    });
    window_->results().stage().show_view(&window_->results().outputs());
    select(SetupOwner::analysis, "printed");
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    const double k = status().result->outputs[0].coverage_factor;
    window_->selection().select_entry(project_address);
    show_group(QStringLiteral("Project"));
    type_into("project_author", QStringLiteral("A. Author"));
    type_into("project_number", QStringLiteral("2026-17"));
    choose("lengths", QStringLiteral("µm"));
    ASSERT_TRUE(wait_for([this] { return cell_of("Unit") == QStringLiteral("µm"); }))
        << to_std(cell_of("Unit"));
    EXPECT_TRUE(status().is_current()) << "no number depends on a unit";
    EXPECT_TRUE(wait_for([this] { return status().result->outputs[0].quantity.unit == Unit::of("um"); }));
    window_->results().units().choose(Unit::of("nm"));
    EXPECT_EQ(window_->document().project().results.style.units.of(Unit::of("m")), Unit::of("nm"))
        << "where the project states a unit, the button edits the project";
    EXPECT_TRUE(window_->preferences().now().units.chosen().empty());
    window_->document().undo_stack().undo();
    choose("project_digits", QStringLiteral("1"));
    EXPECT_TRUE(wait_for([this] { return cell_of("U").trimmed().toDouble() > 0.0; }));
    type_into("project_factor", QStringLiteral("3"));
    EXPECT_NE(k, 3.0);
    EXPECT_TRUE(wait_for([this] {
        return status().is_current() && status().result->outputs[0].coverage_factor == 3.0;
    })) << status().result->outputs[0].coverage_factor;
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/project-page.png"));
    while (window_->document().undo_stack().canUndo()) window_->document().undo_stack().undo();
    EXPECT_EQ(bytes(), before);
    ASSERT_TRUE(wait_for([this] { return cell_of("Unit") == QStringLiteral("mm"); }));
}

TEST_F(ProjectPageSession, TheWheelScrollsThePageAndChangesNothing) {
    open(project_copy());
    window_->selection().select_entry(project_address);
    show_group(QStringLiteral("Project"));
    const std::string before = bytes();
    auto* lengths = field<QComboBox>("lengths");
    settle();
    for (int notch = 0; notch < 3; ++notch) {
        const QPointF at = lengths->rect().center();
        QWheelEvent turned(at, lengths->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                           Qt::NoScrollPhase, false);
        QApplication::sendEvent(lengths, &turned);
        EXPECT_FALSE(turned.isAccepted()) << "it goes on to the page";
    }
    settle();
    EXPECT_EQ(bytes(), before);
    EXPECT_FALSE(lengths->hasFocus());
}

TEST_F(ProjectPageSession, UnitsThatAreShownCanBeThoseOfItsDocuments) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    UnitButton& units = window_->results().units();
    const auto in_documents = [&units] {
        emit units.menu()->aboutToShow();
        return units.menu()->actions().back();
    };
    EXPECT_EQ(in_documents()->text(), QStringLiteral("In Reports and Files Too"));
    EXPECT_FALSE(in_documents()->isEnabled()) << "they have these units";
    units.choose(Unit::of("um"));
    ASSERT_TRUE(in_documents()->isEnabled());
    in_documents()->trigger();
    EXPECT_EQ(window_->document().project().results.style.units.of(Unit::of("m")), Unit::of("um"));
    EXPECT_FALSE(in_documents()->isEnabled());
    window_->document().undo();
    EXPECT_TRUE(window_->document().project().results.style.units.chosen().empty());
    window_->preferences().set({});
}

TEST_F(ProjectPageSession, AProjectIsReleasedAndADraftAgainWhenItChanges) {
    open(project_copy());
    const std::string before = bytes();
    window_->selection().select_entry(project_address);
    show_group(QStringLiteral("Review"));
    type_into("/review/prepared/name", QStringLiteral("A. Ames"));
    type_into("/review/checked/name", QStringLiteral("B. Bell"));
    type_into("/review/released/name", QStringLiteral("C. Cole"));
    auto* release = field<QPushButton>("release");
    ASSERT_TRUE(wait_for([&] { return release->isEnabled(); })) << "the project has no errors";
    QTest::mouseClick(release, Qt::LeftButton);
    const auto* state = field<QLabel>("review_state");
    EXPECT_TRUE(state->text().startsWith(QStringLiteral("Released by C. Cole on "))) << to_std(state->text());
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/review-released.png"));
    type_into("project_author", QStringLiteral("A. Author"));
    EXPECT_TRUE(
        state->text().startsWith(QStringLiteral("Draft again: changed since it was released by C. Cole")))
        << to_std(state->text());
    EXPECT_TRUE(state->text().endsWith(QStringLiteral(": the author."))) << to_std(state->text());
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/review-draft-again.png"));
    window_->document().undo();
    EXPECT_TRUE(state->text().startsWith(QStringLiteral("Released by")));
    while (window_->document().undo_stack().canUndo()) window_->document().undo_stack().undo();
    EXPECT_EQ(bytes(), before);
}

}  // namespace
}  // namespace covaria::ui::project_page_session_test
