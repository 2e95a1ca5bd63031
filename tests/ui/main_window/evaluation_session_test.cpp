// Evaluations as a user meets them: tables and charts of an asset and of a model; pictures are left in the
// build folder for people.
#include <QComboBox>
#include <QDir>
#include <QTabWidget>
#include <QTextBrowser>

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

}  // namespace
}  // namespace covaria::ui::evaluation_session_test
