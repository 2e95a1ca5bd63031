// A user adds a study, chooses what it varies, runs it, looks at the chart and the map, and takes it all
// back.
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/target_box.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/stage.h"
#include "ui/pages/study_tab.h"

namespace covaria::ui::study_session_test {
namespace {

class StudySession : public Session {
protected:
    StudyTab& tab() { return window_->results().study_tab(); }
    void show_study_tab() { window_->results().stage().show_view(&tab()); }
    void press(const char* name) {
        auto* button = field<QPushButton>(name);
        ASSERT_NE(button, nullptr);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    const std::vector<Study>& studies() const {
        return window_->document().project().find_analysis("recommended")->studies;
    }
    StudyStatus study_status() const {
        return window_->runner().studies().status(window_->selection().analysis(),
                                                  window_->selection().study());
    }
    void open_network() {
        open(project_copy(QStringLiteral("lsm-network")));
        select(SetupOwner::analysis, "recommended");
        ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
        show_group(QStringLiteral("Studies"));
    }
};

TEST_F(StudySession, AStudyIsAddedChangedRunAndTakenBack) {
    open_network();
    ASSERT_EQ(studies().size(), 2u);
    press("add_study");
    ASSERT_EQ(studies().size(), 3u);
    EXPECT_EQ(window_->selection().study().toStdString(), studies()[2].id);
    ASSERT_TRUE(field<TargetBox>("axis_0_target")->choose(QStringLiteral("Targets, B: y")));
    EXPECT_EQ(studies()[2].axes[0].target, "/setup/targets/rows/1/y");
    type_into("axis_0_from", QStringLiteral("-1 m"));
    type_into("axis_0_to", QStringLiteral("1"));
    type_into("axis_0_values", QStringLiteral("5"));
    const StudyAxis axis = studies()[2].axes[0];
    EXPECT_EQ(axis.unit.text(), "m");
    EXPECT_EQ(axis.from, -1.0);
    EXPECT_EQ(axis.to, 1.0);
    EXPECT_EQ(axis.values, 5u);
    press("run_study");
    ASSERT_TRUE(wait_for([this] { return study_status().is_current(); }));
    EXPECT_EQ(study_status().result->points.size(), 5u);
    show_study_tab();
    EXPECT_FALSE(tab().chart().plot().series.empty());
    EXPECT_EQ(tab().chart().plot().x.title, "Targets, B: y");
    EXPECT_EQ(tab().chart().plot().x.unit, "m");
    window_->document().undo_stack().undo();
    ASSERT_TRUE(wait_for([this] { return !study_status().is_current(); }));
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("Out of date")));
    while (window_->document().undo_stack().canUndo()) window_->document().undo_stack().undo();
    EXPECT_EQ(studies().size(), 2u);
}

TEST_F(StudySession, TheSceneShowsTheMapWhileTheTabIsOnTop) {
    open_network();
    show_study_tab();
    window_->selection().select_study(QStringLiteral("volume"));
    window_->runner().studies().run(QStringLiteral("recommended"), QStringLiteral("volume"));
    ASSERT_TRUE(wait_for([this] { return study_status().is_current(); }));
    ASSERT_TRUE(wait_for([this] {
        const auto scene = window_->scene().view().scene();
        return scene && scene->map && !window_->scene().is_building();
    }));
    EXPECT_EQ(tab().chart().plot().series[0].kind, SeriesKind::heat_map);
    scene_picture();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/study-map.png"));
    window_->results().stage().show_view(&window_->results().outputs());
    EXPECT_TRUE(wait_for([this] {
        const auto scene = window_->scene().view().scene();
        return scene && !scene->map;
    }));
}

TEST_F(StudySession, AProblemOfAStudyIsListedAndTheAnalysisStillRuns) {
    open_network();
    window_->selection().select_study(QStringLiteral("station-angle"));
    type_into("axis_0_from", QStringLiteral("0"));
    EXPECT_FALSE(problems().filter(QStringLiteral("greater than zero")).isEmpty());
    EXPECT_NE(status().prepared, nullptr);
}

TEST_F(StudySession, TwoAnalysesWithStudiesOfTheirOwnAreLookedAtInTurn) {
    open_network();
    select(SetupOwner::analysis, "paper");
    ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
    show_group(QStringLiteral("Studies"));
    press("add_study");
    const QString added = window_->selection().study();
    for (int i = 0; i < 2; ++i) {
        select(SetupOwner::analysis, "recommended");
        EXPECT_EQ(window_->selection().study().toStdString(), studies().front().id);
        select(SetupOwner::analysis, "paper");
        EXPECT_EQ(window_->selection().study(), added);
    }
}

}  // namespace
}  // namespace covaria::ui::study_session_test
