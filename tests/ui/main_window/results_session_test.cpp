// A user looks for results over all groups, and for those that do not meet what is required.
#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QTimer>
#include <algorithm>

#include "core/propagation/engine.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/document/component_source.h"
#include "ui/models/roles.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"
#include "ui/pages/unit_button.h"
#include "ui/scene_view/scene_view.h"

namespace covaria::ui::results_session_test {
namespace {

class ResultsSession : public Session {
protected:
    const QAbstractItemModel& table() { return *window_->results().outputs().table().model(); }
    int column(const char* head) {
        for (int c = 0; c < table().columnCount(); ++c)
            if (table().headerData(c, Qt::Horizontal, id_role).toString() == QLatin1String(head)) return c;
        return -1;
    }
    QString words(int row, const char* head) { return table().index(row, column(head)).data().toString(); }
};

TEST_F(ResultsSession, ABarAndARowOfTheBudgetLeadToTheirSource) {
    open(project_copy(QStringLiteral("tracker-pose")));
    select(SetupOwner::analysis, "tracker-alone");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    window_->results().stage().show_view(window_->results().budget_tab());
    auto* chart = window_->findChild<ChartView*>(QStringLiteral("contributions_chart"));
    ASSERT_NE(chart, nullptr);
    ASSERT_TRUE(wait_for([&] { return !chart->plot().series.empty(); }));
    settle();
    const PlotGeometry& geometry = chart->chart().chart_layout().geometry;
    const QPoint on_first = geometry.at(0.1, chart->plot().series.front().y.front()).toPoint() + QPoint(2, 0);
    QTest::mouseMove(chart->viewport(), on_first);
    QMouseEvent over(QEvent::MouseMove, on_first, chart->viewport()->mapToGlobal(on_first), Qt::NoButton,
                     Qt::NoButton, {});
    QCoreApplication::sendEvent(chart->viewport(), &over);
    EXPECT_EQ(chart->viewport()->cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(chart->viewport(), Qt::LeftButton, {}, on_first);
    EXPECT_EQ(window_->selection().entry().owner, SetupOwner::asset);
    EXPECT_EQ(window_->selection().entry().id, "tracker") << "it states the component, not the network";
    EXPECT_EQ(window_->results().budget_table().current_row(), 0);
    select(SetupOwner::analysis, "tracker-alone");
    emit window_->results().budget_table().row_activated(1);
    EXPECT_EQ(window_->selection().entry().owner, SetupOwner::asset);
}

/// The budget does not scroll sideways where its chart can spare the room; a handle that was moved stays.
TEST_F(ResultsSession, TheBudgetTakesTheRoomThatItsChartCanSpare) {
    window_->resize(2300, 1000);
    open(project_copy(QStringLiteral("ballbar-design")));
    select(SetupOwner::analysis, "points");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    window_->results().stage().show_view(window_->results().budget_tab());
    SortableTable& budget = window_->results().budget_table();
    ASSERT_TRUE(wait_for([&] { return budget.horizontalScrollBar()->maximum() == 0; }, 3000))
        << budget.horizontalScrollBar()->maximum() << " pixels are missing";
    settle();
    auto* chart = window_->findChild<ChartView*>(QStringLiteral("contributions_chart"));
    EXPECT_GE(chart->width(), 320);
    EXPECT_GT(budget.width(), 3 * chart->width() / 2) << "more than it has by itself";
    auto* splitter = qobject_cast<QSplitter*>(budget.parentWidget());
    ASSERT_NE(splitter, nullptr);
    splitter->setSizes({400, splitter->width() - 400});
    emit splitter->splitterMoved(400, 1);
    settle();
    const int width = budget.width();
    window_->selection().select_output(1);
    settle();
    EXPECT_EQ(budget.width(), width);
}

/// Every component that set-ups state leads to its own place.
TEST_F(ResultsSession, EveryComponentHasAPlaceToGoTo) {
    int checked = 0;
    for (const char* name :
         {"chain", "force-moment-sensor", "stewart-platform", "gum/h1-end-gauge", "lsm-network"}) {
        const auto loaded = load_project(
            to_path(QStringLiteral(COVARIA_SOURCE_DIR "/projects/%1.covaria").arg(QLatin1String(name))));
        for (const AnalysisEntry& analysis : loaded.project.analyses) {
            const auto prepared = loaded.made->analysis(analysis.id);
            ASSERT_TRUE(prepared) << name << ' ' << analysis.id;
            const auto result = evaluate_first_order(*prepared->propagated, prepared->options);
            ASSERT_TRUE(result);
            for (const BudgetComponent& component : result->budget.components) {
                const QString place = place_of_component(loaded.project, *prepared, component);
                EXPECT_TRUE(exists(loaded.project, address_of_path(loaded.project, to_std(place))))
                    << name << ' ' << analysis.id << ' ' << component.id << ": " << to_std(place);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 300);
}

/// The inputs shown for a trial are those that the run drew.
TEST_F(ResultsSession, ADotOfTheCloudTellsItsInputs) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    scene_picture();
    SceneView& view = window_->scene().view();
    LayerVisibility layers;
    layers[Layer::clouds] = true;  // they are shown when asked for
    view.set_layers(layers);
    ASSERT_TRUE(view.scene() && !view.scene()->clouds.empty());
    const SceneCloud* cloud = nullptr;
    for (const SceneCloud& one : view.scene()->clouds)
        if (one.role == covaria::Role::output) cloud = &one;
    ASSERT_NE(cloud, nullptr);
    const auto pixel_of = [&](std::size_t dot) {
        const Eigen::Vector3d p_W = cloud->dot(dot);
        Pixel at;
        view.service().post([&](SceneRenderer& renderer) { at = renderer.project(p_W); });
        view.service().wait_until_idle();
        return QPointF(at.x, at.y) / view.devicePixelRatioF();
    };
    std::size_t clicked = 0;  // not all: where the point itself is meant there is no trial
    for (; clicked < cloud->size() && !view.picked_trial(); clicked += 97) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, pixel_of(clicked).toPoint());
        settle();  // one click after the other
    }
    ASSERT_TRUE(view.picked_trial().has_value());
    const auto of_cloud = std::find(cloud->trials.begin(), cloud->trials.end(), *view.picked_trial());
    if (of_cloud != cloud->trials.end()) {
        const auto found = std::size_t(of_cloud - cloud->trials.begin());
        EXPECT_LT((pixel_of(found) - pixel_of(clicked - 97)).manhattanLength(), 6.0);
    }
    const auto replayed = replay_trials(*status().prepared->propagated, status().prepared->options.seed,
                                        *view.picked_trial(), 1);
    ASSERT_TRUE(replayed);
    const auto words = [&] {
        for (const QLabel* label : window_->scene().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(QStringLiteral("Trial"))) return label->text();
        return QString();
    };
    EXPECT_TRUE(wait_for([&] { return !words().isEmpty(); }, 3000));
    EXPECT_TRUE(words().contains(QStringLiteral("<i>u</i>"))) << to_std(words());
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/trial.png"));
}

TEST_F(ResultsSession, AllGroupsAreFilteredBySearchAndByWhatIsNotMet) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    window_->results().stage().show_view(&window_->results().outputs());
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    window_->selection().select_group(QStringLiteral("pose 7"));
    ASSERT_EQ(table().rowCount(), 6);
    EXPECT_EQ(column("Requirement"), -1) << "nothing is required";
    EXPECT_FALSE(window_->results().outputs().only_not_met().isEnabled());
    QTest::mouseClick(&window_->results().outputs().all_groups(), Qt::LeftButton, {},
                      QPoint(8, window_->results().outputs().all_groups().height() / 2));
    ASSERT_EQ(table().rowCount(), 78);
    EXPECT_FALSE(window_->results().outputs().table().isColumnHidden(column("Group")));
    window_->results().outputs().filter().setFocus();
    QTest::keyClicks(&window_->results().outputs().filter(), QStringLiteral("pose 1 alpha"));
    for (int row = 0; row < table().rowCount(); ++row)
        EXPECT_TRUE(words(row, "Group").startsWith(QStringLiteral("pose 1"))) << row;
    ASSERT_EQ(table().rowCount(), 5) << "poses 1, 10, 11, 12, 13";

    const OutputResult& x = status().result->outputs[0];
    ASSERT_EQ(x.quantity.symbol, "x");
    const double half_mm = 500.0 * x.expanded_uncertainty, twice_mm = 2000.0 * x.expanded_uncertainty;
    window_->document().apply(QStringLiteral("Requirements"), [&](Project& project) {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == "printed")
                analysis.requirements = {{x.quantity.group, "x", Quantity{half_mm, Unit::of("mm")}},
                                         {x.quantity.group, "y", Quantity{twice_mm * 10, Unit::of("mm")}}};
    });
    window_->results().outputs().filter().clear();
    ASSERT_EQ(table().rowCount(), 78);
    ASSERT_GE(column("Requirement"), 0) << "verdicts follow the requirements without a run";
    EXPECT_EQ(words(0, "Requirement"), QStringLiteral("not met"));
    EXPECT_EQ(words(0, "U / target"), QStringLiteral("2.00"));
    EXPECT_EQ(words(1, "Requirement"), QStringLiteral("met"));
    EXPECT_EQ(words(2, "Requirement"), QString());
    QTest::mouseClick(&window_->results().outputs().only_not_met(), Qt::LeftButton, {},
                      QPoint(8, window_->results().outputs().only_not_met().height() / 2));
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(words(0, "Requirement"), QStringLiteral("not met"));
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/results-not-met.png"));
    window_->document().undo_stack().undo();
    EXPECT_EQ(table().rowCount(), 0) << "nothing is required any more";
    EXPECT_TRUE(window_->results().outputs().only_not_met().isEnabled()) << "so that it can be taken back";
}

TEST_F(ResultsSession, OneDialogRequiresOfAllSelectedResults) {
    open(project_copy(QStringLiteral("tracker-pose")));
    select(SetupOwner::analysis, "tracker-alone");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    OutputsTab& tab = window_->results().outputs();
    window_->results().stage().show_view(&tab);
    settle();
    tab.table().clearSelection();
    std::vector<std::string> symbols;
    for (int row = 0; row < 3; ++row) {
        tab.table().selectionModel()->select(table().index(row, 0),
                                             QItemSelectionModel::Select | QItemSelectionModel::Rows);
        symbols.push_back(to_std(table().index(row, 0).data(id_role).toString()));
    }
    const auto required = [this] {
        return window_->document().project().find_analysis("tracker-alone")->requirements;
    };
    const auto before = required();
    const int steps = window_->document().undo_stack().index();
    QTimer::singleShot(0, [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        QApplication::setActiveWindow(dialog);
        auto* target = dialog->findChild<QLineEdit*>(QStringLiteral("targetUncertainty"));
        ASSERT_NE(target, nullptr);
        target->setFocus();
        target->selectAll();
        QTest::keyClicks(target, QStringLiteral("-1 um"));
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        ok->click();
        EXPECT_TRUE(dialog->isVisible()) << "a target uncertainty is above zero";
        target->selectAll();
        QTest::keyClicks(target, QStringLiteral("70 um"));
        auto* upper = dialog->findChild<QLineEdit*>(QStringLiteral("upperLimit"));
        ASSERT_NE(upper, nullptr);
        upper->setFocus();
        ok->click();
    });
    auto* require = tab.findChild<QPushButton*>(QStringLiteral("require"));
    ASSERT_NE(require, nullptr);
    require->click();
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1) << "one step";
    std::size_t found = 0;
    for (const Requirement& r : required()) {
        if (std::ranges::count(symbols, r.symbol) == 0) continue;
        ++found;
        ASSERT_TRUE(r.target_uncertainty) << r.symbol;
        EXPECT_DOUBLE_EQ(r.target_uncertainty->unit.interval_to_si(r.target_uncertainty->value), 70e-6);
    }
    EXPECT_EQ(found, 3u);
    ASSERT_GE(column("Target"), 0) << "a column of the table";
    EXPECT_FALSE(words(0, "Target").isEmpty());
    window_->document().undo_stack().undo();
    EXPECT_EQ(required(), before);
}

/// A target is typed into its cell, for all selected rows of its unit; a text that is none stays, marked.
TEST_F(ResultsSession, RequirementsAreTypedInTheTable) {
    open(project_copy(QStringLiteral("tracker-pose")));
    select(SetupOwner::analysis, "tracker-alone");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    OutputsTab& tab = window_->results().outputs();
    SortableTable& view = tab.table();
    window_->results().stage().show_view(&tab);
    window_->document().apply(QStringLiteral("None"), [](Project& project) {
        for (AnalysisEntry& analysis : project.analyses) analysis.requirements.clear();
    });
    settle();
    ASSERT_GE(column("Target"), 0) << "there before anything is required";
    EXPECT_EQ(column("Requirement"), -1);
    const auto required = [this] {
        return window_->document().project().find_analysis("tracker-alone")->requirements;
    };
    const auto type = [&](int row, const char* head, const QString& text) {
        view.setFocus();
        view.selectionModel()->setCurrentIndex(table().index(row, column(head)),
                                               QItemSelectionModel::NoUpdate);
        QTest::keyClick(view.viewport(), Qt::Key_F2);
        auto* editor = view.viewport()->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        settle();
    };
    view.clearSelection();
    for (const int row : {0, 1, 2, 3})  // x, y, z and an angle
        view.selectionModel()->select(table().index(row, 0),
                                      QItemSelectionModel::Select | QItemSelectionModel::Rows);
    const int steps = window_->document().undo_stack().index();
    type(1, "Target", QStringLiteral("70 um"));
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1) << "one step";
    ASSERT_EQ(required().size(), 3u) << "the angle has another unit";
    for (const Requirement& r : required())
        EXPECT_DOUBLE_EQ(r.target_uncertainty->unit.interval_to_si(r.target_uncertainty->value), 70e-6);
    EXPECT_GE(column("Requirement"), 0);
    EXPECT_EQ(view.currentIndex().row(), 1);
    EXPECT_EQ(view.currentIndex().column(), column("Target")) << "the next one is typed from here";

    type(0, "Target", QStringLiteral("-1 um"));
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1) << "below zero";
    EXPECT_TRUE(table().index(0, column("Target")).data(Qt::BackgroundRole).isValid());
    type(0, "Upper limit", QStringLiteral("x"));
    EXPECT_EQ(window_->document().undo_stack().index(), steps + 1);
    EXPECT_EQ(words(0, "Upper limit"), QStringLiteral("x")) << "as it was typed";
    EXPECT_TRUE(table().index(0, column("Upper limit")).data(Qt::BackgroundRole).isValid());
    EXPECT_TRUE(table().index(0, column("Upper limit")).data(Qt::ToolTipRole).toString().contains("x"));
    type(0, "Upper limit", QStringLiteral("1000"));
    type(0, "Lower limit", QStringLiteral("2000"));
    EXPECT_FALSE(required()[0].lower_limit) << "above the upper one";
    EXPECT_TRUE(table().index(0, column("Lower limit")).data(Qt::BackgroundRole).isValid());
    type(0, "Lower limit", QStringLiteral("-2000"));
    ASSERT_TRUE(required()[0].lower_limit && required()[0].upper_limit);
    const Unit shown = window_->results().units().units().of(status().result->outputs[0].quantity.unit);
    EXPECT_DOUBLE_EQ(required()[0].lower_limit->si(), shown.to_si(-2000.0)) << "in the unit of the table";
    EXPECT_FALSE(table().index(0, column("Lower limit")).data(Qt::BackgroundRole).isValid());

    view.selectionModel()->setCurrentIndex(table().index(0, column("Target")),
                                           QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_FALSE(required()[0].target_uncertainty);
    EXPECT_TRUE(required()[1].target_uncertainty) << "of the selected row only";
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/results-requirements.png"));
    while (window_->document().undo_stack().index() > steps) window_->document().undo_stack().undo();
    EXPECT_TRUE(required().empty());
}

}  // namespace
}  // namespace covaria::ui::results_session_test
