// A user adds a design, chooses what may be chosen, lets it be searched, looks at what was found, takes it
// over in one step and takes it back.
#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QTextBrowser>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/bring_into_view.h"
#include "ui/forms/target_box.h"
#include "ui/pages/data_table_html.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/empty_note.h"
#include "ui/pages/evaluation_view.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/stage.h"

namespace covaria::ui::design_session_test {
namespace {

const char* const candidates_header = "axis,angle [deg],x [mm],y [mm],z [mm]\nx,30,260,200,413.397460\n";
const char* const candidates_row = "x,50,260,226.604444,435.721239\n";

class DesignSession : public Session {
protected:
    DesignTab& tab() { return window_->results().design_tab(); }
    void press(QWidget& in, const char* name) {
        auto* button = in.findChild<QPushButton*>(QString::fromLatin1(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
        settle();  // what was added has its place only then
        bring_into_view(*button);
        settle();
        QTest::mouseClick(button, Qt::LeftButton);
    }
    const AnalysisEntry& analysis() const {
        return *window_->document().project().find_analysis(window_->selection().analysis().toStdString());
    }
    DesignStatus design_status() const {
        return window_->runner().designs().status(window_->selection().analysis(),
                                                  window_->selection().design());
    }
    void open_project(const char* name, const char* id) {
        open(project_copy(QString::fromLatin1(name)));
        select(SetupOwner::analysis, id);
        ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
        show_group(QStringLiteral("Designs"));
        window_->results().stage().show_view(&tab());
    }
};

TEST_F(DesignSession, ARunIsShownAndSymbolsAreSet) {
    open_project("lsm-network", "recommended");
    press(window_->properties(), "add_design");
    ASSERT_TRUE(field<TargetBox>("variable_0_target")->choose(QStringLiteral("Targets, B: y")));
    type_into("variable_0_from", QStringLiteral("-1 m"));
    type_into("variable_0_to", QStringLiteral("1"));
    type_into("design_most_evaluations", QStringLiteral("60"));
    window_->results().stage().show_view(&window_->results().outputs());
    press(window_->properties(), "run_design");
    EXPECT_TRUE(window_->results().stage().shows(tab()));
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }));
    Table table{"outputs", "Uncertainties"};
    table.add("output");
    table.row({std::string("alpha_xy (pose 1)")});
    EXPECT_TRUE(html_of({table}).contains(QStringLiteral("α</i><sub>"))) << html_of({table}).toStdString();
}

TEST_F(DesignSession, NothingIsLeftToStopAfterIt) {
    open_project("lsm-network", "recommended");
    ASSERT_FALSE(analysis().designs.empty());
    window_->runner().designs().run(to_qt(analysis().id), to_qt(analysis().designs.front().id));
    ASSERT_TRUE(window_->runner().designs().wait_until_idle(60'000));
    QCoreApplication::processEvents();
    EXPECT_FALSE(action(QStringLiteral("Stop"))->isEnabled());
}

TEST_F(DesignSession, AVariableIsSearchedTakenOverAsOneEditAndTakenBack) {
    open_project("lsm-network", "recommended");
    const std::size_t before = analysis().designs.size();
    press(window_->properties(), "add_design");
    ASSERT_EQ(analysis().designs.size(), before + 1);
    const auto* what_to_do = tab().findChild<EmptyNote*>();
    ASSERT_NE(what_to_do, nullptr);
    EXPECT_FALSE(what_to_do->isHidden());
    EXPECT_TRUE(what_to_do->text().contains(QStringLiteral("Run"))) << what_to_do->text().toStdString();
    ASSERT_TRUE(field<TargetBox>("variable_0_target")->choose(QStringLiteral("Targets, B: y")));
    type_into("variable_0_from", QStringLiteral("-1 m"));
    type_into("variable_0_to", QStringLiteral("1"));
    type_into("variable_0_tolerance", QStringLiteral("10 mm"));
    type_into("design_starts", QStringLiteral("2"));
    type_into("design_most_evaluations", QStringLiteral("60"));
    const Design design = analysis().designs.back();
    EXPECT_EQ(design.variables[0].number.target, "/setup/targets/rows/1/y");
    EXPECT_EQ(design.variables[0].number.from, -1.0);
    EXPECT_DOUBLE_EQ(design.variables[0].tolerance, 0.01) << "in the unit of the variable";
    EXPECT_EQ(design.starts, 2u);
    EXPECT_EQ(design.most_evaluations, 60u);
    press(tab(), "run_design_tab");
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }));
    EXPECT_TRUE(tab().view().text().toPlainText().contains(QStringLiteral("Values")));
    EXPECT_FALSE(tab().view().chart().plot().series.empty());
    const double chosen = design_status().result->values[0].chosen;
    const Project untouched = window_->document().project();
    const int steps = window_->document().undo_stack().index();
    press(tab(), "take_over_design");
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1) << "one edit";
    const auto& targets = std::get<SetupTable>(analysis().setup.values.at("targets"));
    const double y_mm = targets.units[2].to_si(std::get<double>(targets.rows[1][2])) * 1e3;
    EXPECT_NEAR(y_mm, 1e3 * chosen, 1e-9);
    ASSERT_TRUE(wait_for([this] { return !design_status().is_current(); }));
    EXPECT_TRUE(tab().state_words().contains(QStringLiteral("Out of date")));
    window_->document().undo_stack().undo();
    EXPECT_TRUE(window_->document().project() == untouched);
    EXPECT_TRUE(wait_for([this] { return design_status().is_current(); })) << "what was found counts again";
}

TEST_F(DesignSession, WhatWasKeptBeforeTakingOverIsComparedAndComesBack) {
    open_project("lsm-network", "recommended");
    press(window_->properties(), "add_design");
    ASSERT_TRUE(field<TargetBox>("variable_0_target")->choose(QStringLiteral("Targets, B: y")));
    type_into("variable_0_from", QStringLiteral("-1 m"));
    type_into("variable_0_to", QStringLiteral("1"));
    type_into("design_most_evaluations", QStringLiteral("60"));
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    trigger(QStringLiteral("Keep as Before"));
    const Project kept = window_->document().project();
    ASSERT_EQ(kept.kept.size(), 1u);
    press(tab(), "run_design_tab");
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }));
    press(tab(), "take_over_design");
    EXPECT_EQ(window_->document().project().kept, kept.kept) << "the kept state stays";
    EXPECT_FALSE(analysis().setup == kept.find_analysis("recommended")->setup);
    trigger(QStringLiteral("Run This Analysis"));
    EXPECT_TRUE(wait_for([this] {
        return window_->runner().kept().before(window_->selection().analysis(), status().result) != nullptr;
    }));
    trigger(QStringLiteral("Go Back to Kept State"));
    EXPECT_TRUE(window_->document().project() == kept);
}

TEST_F(DesignSession, RowsAreChosenAndShownWithWhatEachIsWorth) {
    open_project("ballbar-design", "points");
    ASSERT_EQ(window_->selection().design(), QStringLiteral("twelve"));
    type_into("design_keep", QStringLiteral("15"));
    EXPECT_EQ(analysis().designs[0].choose->keep, 15u);
    type_into("design_starts", QStringLiteral("1"));
    field<QListWidget>("design_fixed")->item(3)->setCheckState(Qt::Checked);
    EXPECT_EQ(analysis().designs[0].choose->fixed, (std::vector<std::size_t>{3}));
    press(window_->properties(), "run_design");
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }));
    EXPECT_EQ(design_status().result->rows.size(), 15u);
    EXPECT_EQ(tab().view().chart_list().itemText(0), QStringLiteral("What more rows give"));
    EXPECT_GE(tab().view().chart_list().count(), 3);
    EXPECT_TRUE(
        wait_for([this] { return tab().view().chart().isVisible() && tab().view().chart().width() > 200; }));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/design.png"));
    press(tab(), "take_over_design");
    EXPECT_EQ(std::get<SetupTable>(analysis().setup.values.at("measured_points")).rows.size(), 15u);
}

TEST_F(DesignSession, TheSceneShowsWhatWasFoundWhileItsTabIsOnTop) {
    open_project("ballbar-design", "points");
    type_into("design_starts", QStringLiteral("1"));
    press(tab(), "run_design_tab");
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }));
    const auto map = [this] {
        const auto scene = window_->scene().view().scene();
        return scene && scene->map ? scene->map->title : std::string();
    };
    EXPECT_TRUE(wait_for([&] { return map() == "gain / %"; }));
    EXPECT_EQ(window_->scene().view().scene()->map->positions.size(), 22u);
    EXPECT_FALSE(scene_picture().isNull());
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/design-scene.png"));
    type_into("design_keep", QStringLiteral("13"));
    EXPECT_TRUE(wait_for([this] {
        const auto scene = window_->scene().view().scene();
        return scene && scene->caption.find("out of date") != std::string::npos;
    }));
    window_->results().stage().show_view(&window_->results().outputs());
    EXPECT_TRUE(wait_for([&] { return map().empty(); }));
}

TEST_F(DesignSession, BoxesPricesReductionsAndSeedAreTyped) {
    open_project("lsm-network", "recommended");
    press(window_->properties(), "add_design");
    press(window_->properties(), "keep_out_add");
    type_into("keep_out_0_name", QStringLiteral("pillar"));
    type_into("keep_out_0_to_y", QStringLiteral("2 m"));
    press(window_->properties(), "hidden_by_add");
    press(window_->properties(), "hidden_by_add");
    press(window_->properties(), "hidden_by_0_remove");
    type_into("design_seed", QStringLiteral("18446744073709551615"));
    const auto design = [this]() -> const Design& { return analysis().designs.back(); };
    ASSERT_EQ(design().keep_out.size(), 1u);
    EXPECT_EQ(design().keep_out[0].name, "pillar");
    EXPECT_EQ(design().keep_out[0].unit, Unit::of("m"));
    EXPECT_DOUBLE_EQ(design().keep_out[0].to[1], 2.0);
    EXPECT_DOUBLE_EQ(design().keep_out[0].to[0], 1.0) << "follows into the unit just typed";
    EXPECT_EQ(design().hidden_by.size(), 1u);
    EXPECT_EQ(design().seed, 18446744073709551615u);
    type_into("design_seed", QStringLiteral("one"));
    EXPECT_EQ(design().seed, 18446744073709551615u);
    press(window_->properties(), "add_reduction");
    ASSERT_EQ(design().reductions.size(), 1u);
    type_into("reduction_0_price", QStringLiteral("120"));
    type_into("reduction_0_least", QStringLiteral("0.25"));
    EXPECT_EQ(design().reductions[0].price, 120.0);
    EXPECT_EQ(design().reductions[0].number.from, 0.25);
    press(window_->properties(), "reduction_0_remove");
    EXPECT_TRUE(design().reductions.empty());
}

TEST_F(DesignSession, PricesOfRowsAreTyped) {
    open_project("ballbar-design", "points");
    type_into("design_prices", QStringLiteral("120"));
    EXPECT_EQ(analysis().designs[0].choose->prices, (std::vector<double>{120.0}));
    type_into("design_prices", QStringLiteral("1; 2"));
    EXPECT_FALSE(problems().filter(QStringLiteral("one price for all rows")).isEmpty());
    type_into("design_prices", QStringLiteral("1; two"));
    EXPECT_EQ(analysis().designs[0].choose->prices.size(), 2u) << "what is no number changes nothing";
}

TEST_F(DesignSession, AChangedFileOfCandidatesMakesTheResultOld) {
    const QString project = project_copy(QStringLiteral("ballbar-design"));
    const QString file = QFileInfo(project).absolutePath() + QStringLiteral("/more.csv");
    const auto write = [&](const char* text) {
        QFile csv(file);
        ASSERT_TRUE(csv.open(QIODevice::WriteOnly));
        csv.write(text);
    };
    write(candidates_header);
    open(project);
    select(SetupOwner::analysis, "points");
    ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
    show_group(QStringLiteral("Designs"));
    window_->results().stage().show_view(&tab());
    type_into("design_candidates", QStringLiteral("more.csv"));
    type_into("design_starts", QStringLiteral("1"));
    type_into("design_most_evaluations", QStringLiteral("30"));
    press(tab(), "run_design_tab");
    ASSERT_TRUE(wait_for([this] { return design_status().is_current(); }))
        << tab().state_words().toStdString();
    write((std::string(candidates_header) + candidates_row).c_str());
    EXPECT_TRUE(wait_for([this] { return !design_status().is_current(); }));
    write(candidates_header);
    EXPECT_TRUE(wait_for([this] { return design_status().is_current(); })) << "as it was searched";
}

TEST_F(DesignSession, ASearchIsStopped) {
    open_project("ballbar-design", "points");
    type_into("design_most_evaluations", QStringLiteral("100000000"));
    type_into("design_starts", QStringLiteral("10000"));
    press(tab(), "run_design_tab");
    ASSERT_TRUE(wait_for([this] { return tab().state_words().contains(QStringLiteral("searching")); }));
    press(tab(), "stop_design");
    ASSERT_TRUE(wait_for([this] { return !window_->runner().designs().is_busy(); }));
    EXPECT_EQ(design_status().result, nullptr);
    EXPECT_EQ(design_status().state, RunState::out_of_date);
}

TEST_F(DesignSession, AProblemOfADesignIsListedAndTheAnalysisStillRuns) {
    open_project("ballbar-design", "points");
    type_into("design_keep", QStringLiteral("99"));
    EXPECT_FALSE(problems().filter(QStringLiteral("can be kept")).isEmpty());
    EXPECT_NE(status().prepared, nullptr);
}

}  // namespace
}  // namespace covaria::ui::design_session_test
