// A user keeps the results, edits, reads what changed beside what was, and goes back or keeps the edit.
#include <QDir>
#include <QMenu>
#include <QToolButton>

#include "core/document/document_writers.h"
#include "core/report/report.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/models/roles.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/current_results.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/scene_view/scene_view.h"

namespace covaria::ui::compare_session_test {
namespace {

class CompareSession : public Session {
protected:
    CompareTab& tab() { return window_->results().compare_tab(); }
    void press(const char* name) {
        auto* button = tab().findChild<QToolButton*>(QString::fromLatin1(name) + QStringLiteral("_button"));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool enabled(const char* name) {
        return tab().findChild<QAction*>(QString::fromLatin1(name))->isEnabled();
    }
    void open_platform() {
        open(project_copy());
        select(SetupOwner::analysis, "printed");
        window_->results().stage().show_view(&tab());
        run();
    }
    void run() {
        trigger(QStringLiteral("Run This Analysis"));
        ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    }
    /// The number of the cell in the row and under the head.
    static double number(const SortableTable& table, int row, const QString& head) {
        const QAbstractItemModel& model = *table.model();
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal, id_role).toString() == head)
                return model.index(row, c).data(exact_role).toDouble();
        ADD_FAILURE() << "no column " << head.toStdString();
        return 0.0;
    }
    static QString words(const SortableTable& table, int row, const QString& head) {
        const QAbstractItemModel& model = *table.model();
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal, id_role).toString() == head)
                return model.index(row, c).data().toString();
        return {};
    }
};

TEST_F(CompareSession, WhatWasKeptStandsBesideWhatIsEdited) {
    open_platform();
    EXPECT_FALSE(enabled("go_back"));
    EXPECT_FALSE(enabled("discard_kept"));
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("Keep the present results")));
    trigger(QStringLiteral("Keep as Before"));
    const Project kept = window_->document().project();
    const double U_before = expanded_uncertainty(0);
    ASSERT_GT(tab().results().model()->rowCount(), 0);
    EXPECT_EQ(number(tab().results(), 0, QStringLiteral("U before")),
              number(tab().results(), 0, QStringLiteral("U after")));
    type_into("base_u_x", QStringLiteral("0.5 mm"));
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) > 1.1 * U_before; }));
    run();
    const Unit& unit = status().result->outputs[0].quantity.unit;
    EXPECT_DOUBLE_EQ(number(tab().results(), 0, QStringLiteral("U before")), unit.interval_from_si(U_before));
    EXPECT_DOUBLE_EQ(number(tab().results(), 0, QStringLiteral("U after")),
                     unit.interval_from_si(expanded_uncertainty(0)));
    EXPECT_GT(number(tab().results(), 0, QStringLiteral("Change of U in %")), 0.1);
    window_->selection().select_output(0);
    ASSERT_GT(tab().budget().model()->rowCount(), 3);
    EXPECT_EQ(words(tab().budget(), 0, QStringLiteral("Kind of change")), QStringLiteral("changed"));
    double sum = 0.0;
    for (int row = 0; row < tab().budget().model()->rowCount(); ++row)
        sum += number(tab().budget(), row, QStringLiteral("Change of variance / %"));
    EXPECT_GT(sum, 0.1);
    EXPECT_EQ(tab().chart().plot().series.size(), 2u);
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/compare.png"));
    choose_in(tab().chart_list(), QStringLiteral("Changes of the budget"));
    EXPECT_TRUE(tab().chart().plot().horizontal_bars);
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/compare-budget.png"));

    const auto ellipsoids_before = [this] {
        const Scene* scene = window_->scene().view().scene();
        return scene ? scene->ellipsoids_before.size() : 0;
    };
    EXPECT_TRUE(wait_for([&] { return ellipsoids_before() > 0; })) << "of both in the scene";
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/compare-scene.png"));
    const Project edited = window_->document().project();
    const int steps = window_->document().undo_stack().index();
    press("go_back");
    EXPECT_TRUE(window_->document().project() == kept);
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1) << "one edit";
    EXPECT_FALSE(enabled("go_back")) << "it is what was kept";
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) < 1.1 * U_before; }));
    run();
    EXPECT_DOUBLE_EQ(expanded_uncertainty(0), U_before) << "the same draws";
    window_->document().undo_stack().undo();
    EXPECT_TRUE(window_->document().project() == edited);
    EXPECT_TRUE(enabled("go_back"));
    press("discard_kept");
    EXPECT_TRUE(wait_for([&] { return ellipsoids_before() == 0; }));
    EXPECT_EQ(tab().results().model()->rowCount(), 0);
    EXPECT_FALSE(enabled("go_back"));
    EXPECT_EQ(window_->document().project().assets, edited.assets);
    EXPECT_EQ(window_->document().project().analyses, edited.analyses);
}

/// The report to be printed, as preview and export build it.
std::string report_now(MainWindow& window) {
    const ReportMaker::Source source =
        document_source(DocumentKind::report, window.document().project(), window.runner());
    return to_markdown(build_report(*source.made, source.analyses, source.failed));
}

TEST_F(CompareSession, TheReportHasBothWhileTheyAreKept) {
    open_platform();
    const std::string chapter = "Results before and after";
    EXPECT_EQ(report_now(*window_).find(chapter), std::string::npos) << "nothing is kept";
    press("keep_before");
    EXPECT_EQ(report_now(*window_).find(chapter), std::string::npos) << "the same results";
    const double U_before = expanded_uncertainty(0);
    type_into("base_u_x", QStringLiteral("0.5 mm"));
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) > 1.1 * U_before; }));
    run();
    const std::string text = report_now(*window_);
    EXPECT_NE(text.find(chapter), std::string::npos);
    EXPECT_NE(text.find("compared-"), std::string::npos) << "distributions of both";
    press("discard_kept");
    EXPECT_EQ(report_now(*window_).find(chapter), std::string::npos);
}

TEST_F(CompareSession, APreviewIsNotKeptAndWhatIsOutOfDateSaysSo) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    window_->results().stage().show_view(&tab());
    run();
    press("keep_before");
    if (window_->runner().is_live()) trigger(QStringLiteral("Live"));
    ASSERT_FALSE(window_->runner().is_live());
    type_into("base_u_x", QStringLiteral("0.5 mm"));
    ASSERT_TRUE(wait_for([this] { return !status().is_current(); }));
    EXPECT_TRUE(wait_for([this] { return !enabled("keep_before"); }, 2000)) << "these results do not count";
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("<b>"))) << to_std(tab().state_words());
}

TEST_F(CompareSession, KeepingAgainSaysThatItReplaces) {
    open_platform();
    const auto* keep = tab().findChild<QAction*>(QStringLiteral("keep_before"));
    EXPECT_EQ(keep->text(), QStringLiteral("Keep as Before"));
    press("keep_before");
    EXPECT_EQ(keep->text(), QStringLiteral("Replace Kept State"));
    press("discard_kept");
    EXPECT_EQ(keep->text(), QStringLiteral("Keep as Before"));
}

TEST_F(CompareSession, AnotherProjectForgetsWhatWasKept) {
    open_platform();
    press("keep_before");
    EXPECT_TRUE(enabled("discard_kept"));
    open(project_copy(QStringLiteral("lsm-network")));
    EXPECT_FALSE(enabled("discard_kept"));
    EXPECT_EQ(tab().results().model()->rowCount(), 0);
}

TEST_F(CompareSession, WhatWasKeptIsThereTomorrow) {
    open_platform();
    const QString file = window_->document().file();
    press("keep_before");
    EXPECT_TRUE(window_->document().is_modified()) << "there is something to save";
    const double U_before = expanded_uncertainty(0);
    const std::vector<AssetEntry> assets_before = window_->document().project().assets;
    type_into("base_u_x", QStringLiteral("0.5 mm"));
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) > 1.1 * U_before; }));
    run();
    const auto numbers = [this] {
        std::vector<double> all;
        for (int row = 0; row < tab().results().model()->rowCount(); ++row)
            for (const char* head : {"U before", "U after", "Change of U in %"})
                all.push_back(number(tab().results(), row, QString::fromLatin1(head)));
        return all;
    };
    const std::vector<double> today = numbers();
    ASSERT_FALSE(today.empty());
    trigger(QStringLiteral("Save"));
    EXPECT_FALSE(window_->document().is_modified());

    open(project_copy(QStringLiteral("lsm-network")));
    EXPECT_FALSE(enabled("discard_kept"));
    open(file);
    select(SetupOwner::analysis, "printed");
    window_->results().stage().show_view(&tab());
    EXPECT_TRUE(enabled("discard_kept"));
    EXPECT_FALSE(window_->document().is_modified());
    run();
    ASSERT_TRUE(wait_for([&] { return tab().results().model()->rowCount() > 0; }))
        << to_std(tab().state_words());
    wait_until_idle();
    EXPECT_EQ(numbers(), today) << "to the last bit";
    EXPECT_NE(report_now(*window_).find("Results before and after"), std::string::npos);
    press("go_back");
    EXPECT_EQ(window_->document().project().assets, assets_before);
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) < 1.1 * U_before; }));
    run();
    EXPECT_EQ(expanded_uncertainty(0), U_before);
    EXPECT_EQ(report_now(*window_).find("Results before and after"), std::string::npos)
        << "they are the same again";
}

TEST_F(CompareSession, KeepingAndDiscardingAreTakenBack) {
    open_platform();
    const double U_before = expanded_uncertainty(0);
    press("keep_before");
    EXPECT_EQ(window_->document().undo_stack().undoText(), QStringLiteral("Keep state"));
    window_->document().undo();
    EXPECT_FALSE(enabled("discard_kept"));
    EXPECT_FALSE(window_->document().is_modified());
    press("keep_before");
    type_into("base_u_x", QStringLiteral("0.5 mm"));
    ASSERT_TRUE(wait_for([&] { return expanded_uncertainty(0) > 1.1 * U_before; }));
    run();
    press("discard_kept");
    EXPECT_EQ(tab().results().model()->rowCount(), 0);
    window_->document().undo();
    ASSERT_TRUE(wait_for([&] { return tab().results().model()->rowCount() > 0; })) << "computed again";
    const Unit& unit = status().result->outputs[0].quantity.unit;
    EXPECT_EQ(number(tab().results(), 0, QStringLiteral("U before")), unit.interval_from_si(U_before));
}

TEST_F(CompareSession, AnyTwoAnalysesStandBesideEachOther) {
    open_platform();
    select(SetupOwner::analysis, "from-artefacts");
    run();
    const double of_other = expanded_uncertainty(0);
    select(SetupOwner::analysis, "printed");
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("Compare With")));
    const auto choose_other = [this](const QString& words) {
        emit tab().others().aboutToShow();
        for (QAction* action : tab().others().actions())
            if (action->text() == words) return action->trigger();
        FAIL() << words.toStdString();
    };
    choose_other(QStringLiteral("Point uncertainties from the artefacts"));
    ASSERT_TRUE(wait_for([this] { return tab().results().model()->rowCount() > 0; }));
    const Unit& unit = status().result->outputs[0].quantity.unit;
    EXPECT_EQ(number(tab().results(), 0, QStringLiteral("U before")), unit.interval_from_si(of_other));
    EXPECT_EQ(number(tab().results(), 0, QStringLiteral("U after")),
              unit.interval_from_si(expanded_uncertainty(0)));
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("Point uncertainties from the artefacts")));
    EXPECT_FALSE(enabled("go_back")) << "this analysis was never that one";
    settle();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/compare-other.png"));
    EXPECT_NE(report_now(*window_).find("Point uncertainties from the artefacts; "), std::string::npos);

    tab().ask_for_file = [this] { return project_copy(QStringLiteral("tracker-pose")); };
    QStringList offered;
    tab().ask_for_analysis = [&offered](const QStringList& names) {
        offered = names;
        return names.back();
    };
    const double before = number(tab().results(), 0, QStringLiteral("U before"));
    choose_other(QStringLiteral("Another Project …"));
    EXPECT_EQ(offered.size(), 2);
    ASSERT_TRUE(wait_for([&] {
        return tab().results().model()->rowCount() > 0 &&
               number(tab().results(), 0, QStringLiteral("U before")) != before;
    }));
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("tracker-pose.covaria: ")));
    window_->document().undo();
    ASSERT_TRUE(wait_for([&] {
        return tab().results().model()->rowCount() > 0 &&
               number(tab().results(), 0, QStringLiteral("U before")) == before;
    }));
}

TEST_F(CompareSession, WhatIsKeptOfADeletedAnalysisGoesWithIt) {
    open_platform();
    press("keep_before");
    ASSERT_EQ(window_->document().project().kept.size(), 1u);
    trigger(QStringLiteral("Delete"));
    EXPECT_TRUE(window_->document().project().kept.empty());
    window_->document().undo();
    EXPECT_EQ(window_->document().project().kept.size(), 1u);
}

}  // namespace
}  // namespace covaria::ui::compare_session_test
