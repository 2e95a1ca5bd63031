// Texts that cannot be read: a problem with a place, wherever they stand, that holds the run until it is
// solved; and fields that take the keyboard.
#include <QLineEdit>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/correlation_edit.h"
#include "ui/forms/target_box.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/field_help.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/stage.h"

namespace covaria::ui::unread_session_test {
namespace {

class UnreadSession : public Session {
protected:
    /// The project is as it was, but neither run nor reported.
    void expect_held(const QString& said) {
        const QString listed = problems().join(QLatin1Char('\n'));
        EXPECT_TRUE(listed.contains(said)) << listed.toStdString();
        ASSERT_TRUE(wait_for([this] { return !window_->runner().is_busy(); }));
        EXPECT_EQ(status().state, RunState::failed);
        EXPECT_FALSE(status().is_current());
        trigger(QStringLiteral("Run This Analysis"));
        trigger(QStringLiteral("Run All"));
        ASSERT_TRUE(wait_for([this] { return !window_->runner().is_busy(); }));
        EXPECT_EQ(status().state, RunState::failed) << "a run waits until the text is mended";
        EXPECT_TRUE(status().message.contains(said)) << status().message.toStdString();
    }
    void expect_released() {
        EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
        wait_until_idle();
        EXPECT_TRUE(status().is_current());
    }
    /// Remembers where the pictures of the scene are seen from.
    void watch_camera() {
        QObject::connect(&window_->scene().view().service(), &RenderService::rendered, window_.get(),
                         [this](const QImage&, const Camera& camera) { cameras_.push_back(camera); });
    }
    std::vector<Camera> cameras_;
    void leave_and_come_back() {
        const SetupAddress entry = window_->selection().entry();
        select(SetupOwner::asset, window_->document().project().assets.front().id);
        window_->selection().select_entry(entry);
    }
};

TEST_F(UnreadSession, AFieldHoldsTheRunUntilItCanBeRead) {
    open(project_copy());
    wait_until_idle();
    const std::string before = bytes();
    for (const char* text : {"12 kg", "344,5,6", "abc"}) {
        type_into("base_u_x", QString::fromLatin1(text));
        EXPECT_EQ(bytes(), before);
        expect_held(QString::fromLatin1(text).section(QLatin1Char(' '), -1));
        leave_and_come_back();
        EXPECT_EQ(field<QLineEdit>("base_u_x")->text(), QString::fromLatin1(text)) << "not lost";
    }
    type_into("base_u_x", QStringLiteral("0.066 mm"));
    EXPECT_EQ(bytes(), before);
    expect_released();
}

TEST_F(UnreadSession, ACellHoldsTheRunUntilItCanBeRead) {
    open(project_copy());
    wait_until_idle();
    const QString before = cell("poses", 2, 1);
    go_to_cell("poses", 2, 1);
    type_keys(QStringLiteral("12kg"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    ASSERT_TRUE(wait_for([this] { return cell("poses", 2, 1) == QStringLiteral("12kg"); }));
    expect_held(QStringLiteral("kg"));
    leave_and_come_back();
    EXPECT_EQ(cell("poses", 2, 1), QStringLiteral("12kg"));
    paste("poses", 2, 1, before);
    expect_released();
}

TEST_F(UnreadSession, ACorrelationHoldsTheRunUntilItCanBeRead) {
    open(project_copy());
    wait_until_idle();
    show_group(QStringLiteral("Inputs"));
    auto* edit = window_->properties().findChild<CorrelationEdit*>();
    ASSERT_NE(edit, nullptr);
    InputCorrelationModel& model = edit->model();
    const std::vector<std::string> others = model.other_components();
    ASSERT_GE(others.size(), 2U);
    model.add_component(others[0]);
    model.add_component(others[1]);
    ASSERT_TRUE(model.setData(model.index(0, 1), QStringLiteral("1.5")));
    EXPECT_EQ(model.index(0, 1).data().toString(), QStringLiteral("1.5"));
    EXPECT_EQ(model.index(1, 0).data().toString(), QStringLiteral("1.5")) << "the matrix is symmetric";
    expect_held(QStringLiteral("1.5"));
    window_->properties().focus_field(to_qt(window_->document().problems().items().front().path));
    EXPECT_TRUE(edit->isVisible()) << "not the components, which are no part of it";
    EXPECT_EQ(edit->view().currentIndex().data().toString(), QStringLiteral("1.5"));
    ASSERT_TRUE(model.setData(model.index(0, 1), QStringLiteral("0")));
    wait_until_idle();
    EXPECT_TRUE(status().is_current());
}

TEST_F(UnreadSession, AStudyHoldsItsOwnRun) {
    open(project_copy(QStringLiteral("lsm-network")));
    select(SetupOwner::analysis, "recommended");
    wait_until_idle();
    show_group(QStringLiteral("Studies"));
    window_->selection().select_study(QStringLiteral("station-angle"));
    type_into("axis_0_from", QStringLiteral("12 kg"));
    EXPECT_FALSE(problems().filter(QStringLiteral("kg")).isEmpty());
    EXPECT_TRUE(status().is_current()) << "the analysis has nothing to do with it";
    window_->runner().studies().run(QStringLiteral("recommended"), QStringLiteral("station-angle"));
    const StudyStatus& study =
        window_->runner().studies().status(QStringLiteral("recommended"), QStringLiteral("station-angle"));
    EXPECT_EQ(study.state, RunState::failed);
    EXPECT_TRUE(study.message.contains(QStringLiteral("kg")));
}

/// A text in an entry that is gone can neither be saved nor lost.
TEST_F(UnreadSession, WhatStoodInAnEntryThatIsGoneIsNotAskedFor) {
    open(project_copy(QStringLiteral("lsm-network")));
    select(SetupOwner::analysis, "recommended");
    wait_until_idle();
    show_group(QStringLiteral("Studies"));
    window_->selection().select_study(QStringLiteral("station-angle"));
    type_into("axis_0_from", QStringLiteral("12 kg"));
    Document& document = window_->document();
    EXPECT_EQ(document.unread().count(document.project()), 1);
    document.apply(QStringLiteral("Delete"), [](Project& project) {
        std::erase_if(project.analyses, [](const AnalysisEntry& entry) { return entry.id == "recommended"; });
    });
    EXPECT_EQ(document.unread().count(document.project()), 0);
    trigger(QStringLiteral("Save"));
    EXPECT_FALSE(document.is_modified());
    trigger(QStringLiteral("New Project"));
    EXPECT_EQ(answer_.save_questions, 0) << "all of it is saved";
}

TEST_F(UnreadSession, TheTargetOfAStudyIsTypedIn) {
    open(project_copy(QStringLiteral("lsm-network")));
    select(SetupOwner::analysis, "recommended");
    wait_until_idle();
    show_group(QStringLiteral("Studies"));
    window_->selection().select_study(QStringLiteral("station-angle"));
    auto* target = field<TargetBox>("axis_0_target");
    const auto axis = [this] {
        for (const Study& each : window_->document().project().find_analysis("recommended")->studies)
            if (each.id == "station-angle") return each.axes.front();
        return StudyAxis{};
    };
    const std::string before = axis().target;
    target->setFocus();
    target->lineEdit()->selectAll();
    QTest::keyClicks(target, QStringLiteral("Targets, B: y"));
    QTest::keyClick(target, Qt::Key_Return);
    EXPECT_EQ(axis().target, "/setup/targets/rows/1/y");
    target->setFocus();
    target->lineEdit()->selectAll();
    QTest::keyClicks(target, QStringLiteral("no such thing"));
    QTest::keyClick(target, Qt::Key_Tab);
    EXPECT_EQ(axis().target, "/setup/targets/rows/1/y");
    EXPECT_EQ(target->lineEdit()->text(), QStringLiteral("no such thing")) << "not taken back in silence";
    EXPECT_FALSE(problems().filter(QStringLiteral("no such thing")).isEmpty());
    EXPECT_NE(before, axis().target);
}

TEST_F(UnreadSession, TheHelpForgetsComplaintsThatAreSolved) {
    open(project_copy());
    wait_until_idle();
    window_->activateWindow();
    QApplication::setActiveWindow(window_.get());
    auto* help = window_->properties().findChild<FieldHelp*>();
    type_into("base_u_x", QStringLiteral("12 kg"));
    EXPECT_TRUE(help->text().contains(QStringLiteral("kg"))) << help->text().toStdString();
    type_into("base_u_x", QStringLiteral("0.066 mm"));
    EXPECT_FALSE(help->text().contains(QStringLiteral("kg"))) << help->text().toStdString();
}

TEST_F(UnreadSession, ANewProjectKeepsNothingOfTheOldOne) {
    open(project_copy());
    wait_until_idle();
    type_into("base_u_x", QStringLiteral("12 kg"));
    type_into("base_u_x", QStringLiteral("0.07 mm"));
    wait_until_idle();
    scene_picture();
    window_->scene().view().set_view(StandardView::top);
    auto* report = window_->results().findChild<ReportPreview*>();
    window_->results().stage().show_view(report);
    ASSERT_TRUE(wait_for([&] { return report->page_count() > 0; }, 120'000));
    type_into("base_u_y", QStringLiteral("12 kg"));
    trigger(QStringLiteral("New Project"));
    EXPECT_EQ(report->page_count(), 0U);
    EXPECT_TRUE(problems().isEmpty());
    const auto* help = window_->properties().findChild<FieldHelp*>();
    EXPECT_FALSE(help->text().contains(QStringLiteral("kg"))) << help->text().toStdString();

    answer_.save = SaveAnswer::discard;
    open(project_copy());
    wait_until_idle();
    scene_picture();
    watch_camera();
    window_->scene().view().fit();
    scene_picture();
    window_->scene().view().set_view(StandardView::iso);
    scene_picture();
    ASSERT_GE(cameras_.size(), 2U);
    EXPECT_TRUE(cameras_.front().direction.isApprox(cameras_.back().direction)) << "seen from the usual side";
}

TEST_F(UnreadSession, ARobotWithoutStatedUncertaintyIsWarnedOf) {
    open(project_copy());
    for (const char* name : {"base_u_x", "base_u_y", "base_u_z", "moving_u_x", "moving_u_y", "moving_u_z"})
        type_into(name, QStringLiteral("0 mm"));
    EXPECT_FALSE(problems().filter(QStringLiteral("no input quantity has an uncertainty")).isEmpty())
        << problems().join(QLatin1Char('\n')).toStdString();
}

}  // namespace
}  // namespace covaria::ui::unread_session_test
