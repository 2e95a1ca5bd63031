// Evaluations as a user meets them: tables and charts of an asset and of a model; pictures are left in the
// build folder for people.
#include <QComboBox>
#include <QDir>
#include <QTabWidget>
#include <QTextBrowser>
#include <QUndoStack>
#include <QUrl>
#include <algorithm>

#include "tests/ui/main_window/window_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/main_window/theme_switch.h"
#include "ui/pages/evaluation_view.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/fold_groups.h"

namespace covaria::ui::evaluation_session_test {
namespace {

class EvaluationSession : public WindowFixture {
protected:
    void shoot(const QString& name) {
        settle();
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().toImage().save(folder.filePath(name + QStringLiteral(".png")));
    }

    static EvaluationView* shown_in(QTabWidget& tabs) {
        for (int i = 0; i < tabs.count(); ++i)
            if (auto* view = qobject_cast<EvaluationView*>(tabs.widget(i))) {
                tabs.setCurrentIndex(i);
                return view;
            }
        return nullptr;
    }

    /// Evaluations come from a worker thread.
    static bool wait_for_text(EvaluationView& view, const QString& words) {
        return QTest::qWaitFor([&] { return view.text().toPlainText().contains(words); }, 20'000);
    }
};

TEST_F(EvaluationSession, AnAssetShowsItsTablesAndCharts) {
    open(project_copy(QStringLiteral("force-moment-sensor")));
    wait_until_idle();
    window_->selection().select_entry({SetupOwner::asset, "sensor"});
    auto* view = window_->properties().findChild<EvaluationView*>();
    ASSERT_NE(view, nullptr);
    FoldGroups::reveal(*view);
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("Kim, Table 3")));
    for (const char* const number : {"0.004 81", "1.6671", "2.78"})
        EXPECT_TRUE(view->text().toPlainText().contains(QLatin1String(number))) << number;
    QComboBox& list = view->chart_list();
    EXPECT_TRUE(list.isVisible());
    EXPECT_EQ(list.count(), 21);  // map, parts of U, plan; three for each of six channels
    for (int i = 0; i < list.count(); ++i) {
        list.setCurrentIndex(i);
        EXPECT_FALSE(view->chart().plot().series.empty()) << list.itemText(i).toStdString();
    }
    list.setCurrentIndex(list.findText(QStringLiteral("Hysteresis loop, magnified, of Mx")));
    EXPECT_EQ(view->chart().plot().id, "loop-mx");
    shoot(QStringLiteral("evaluation-asset-light"));
    window_->findChild<ThemeSwitch*>()->choose(QStringLiteral("dark"));
    list.setCurrentIndex(0);
    shoot(QStringLiteral("evaluation-asset-dark"));
    window_->findChild<ThemeSwitch*>()->choose(QStringLiteral("light"));
}

TEST_F(EvaluationSession, AModelShowsThePaperBesideTheGum) {
    open(project_copy(QStringLiteral("force-moment-sensor")));
    wait_until_idle();
    EvaluationView* view = shown_in(window_->results().tabs());
    ASSERT_NE(view, nullptr);
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("the linear sum is no bound under combined load")));
    shown_in(window_->results().tabs());  // the tab is there once there is something to show
    EXPECT_TRUE(view->isVisible());
    EXPECT_TRUE(view->text().toPlainText().contains(QStringLiteral("2.637")));
    EXPECT_EQ(view->chart().plot().id, "paper-and-gum");
    shoot(QStringLiteral("evaluation-model-light"));
    window_->selection().select_entry({SetupOwner::analysis, "loads"});
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("Decoupling matrix")));
    EXPECT_EQ(view->chart().plot().id, "uncompensated");
    shoot(QStringLiteral("evaluation-loads-light"));
}

TEST_F(EvaluationSession, AReadingIsLeftOutWhereItsResidualStands) {
    open(project_copy(QStringLiteral("tracker-network")));
    wait_until_idle();
    EvaluationView* view = shown_in(window_->results().tabs());
    ASSERT_NE(view, nullptr);
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("Residuals of the readings")));
    const QString html = view->text().toHtml();
    const qsizetype at = html.indexOf(QStringLiteral("choose:/readings/"));
    ASSERT_GE(at, 0) << "the reading with the largest |w| offers it";
    const QUrl link(html.mid(at, html.indexOf(QLatin1Char('"'), at) - at));
    const auto readings = [&]() -> const SetupTable& {
        const covaria::Setup& setup = window_->document().project().analyses.front().setup;
        return std::get<SetupTable>(setup.values.at("readings"));
    };
    const SetupTable before = readings();
    ASSERT_FALSE(before.csv_file.empty()) << "the example has its readings in a file";
    const auto left_out = [&] {
        return std::ranges::count_if(readings().rows, [](const std::vector<SetupCell>& row) {
            return std::ranges::count(row, SetupCell(std::string("left-out"))) > 0;
        });
    };
    EXPECT_EQ(left_out(), 0);
    emit view->text().anchorClicked(link);
    EXPECT_EQ(left_out(), 1);
    EXPECT_TRUE(readings().csv_file.empty()) << "the file stays as it is";
    wait_until_idle();
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("What is left out")));
    const QString now = view->text().toHtml();
    const qsizetype again = now.indexOf(QStringLiteral("use?used"));
    ASSERT_GE(again, 0);
    const qsizetype begin = now.lastIndexOf(QStringLiteral("choose:"), again);
    emit view->text().anchorClicked(QUrl(now.mid(begin, now.indexOf(QLatin1Char('"'), begin) - begin)));
    EXPECT_EQ(left_out(), 0);
    window_->document().undo_stack().undo();
    EXPECT_EQ(left_out(), 1);
    window_->document().undo_stack().undo();
    EXPECT_EQ(readings(), before) << "from the file again";
}

TEST_F(EvaluationSession, AResidualLeadsToItsReading) {
    open(project_copy(QStringLiteral("tracker-network")));
    wait_until_idle();
    EvaluationView* view = shown_in(window_->results().tabs());
    ASSERT_NE(view, nullptr);
    ASSERT_TRUE(wait_for_text(*view, QStringLiteral("Residuals of the readings")));
    QStringList places;
    QObject::connect(&window_->results(), &ResultsPane::place_wanted, view,
                     [&](const QString& place) { places << place; });
    emit view->text().anchorClicked(QUrl(QStringLiteral("place:/readings/rows/4")));
    EXPECT_EQ(places, QStringList(QStringLiteral("/analyses/0/setup/readings/rows/4")));
    emit view->text().anchorClicked(QUrl(QStringLiteral("https://example.org")));
    EXPECT_EQ(places.size(), 1);
}

}  // namespace
}  // namespace covaria::ui::evaluation_session_test
