// How the window looks beyond the tabs of results: properties, start page, toolbar; every picture is left in
// the build folder for people.
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

#include "tests/ui/main_window/window_fixture.h"
#include "ui/main_window/theme_switch.h"
#include "ui/models/roles.h"
#include "ui/pages/example_card.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/run_status.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/unit_button.h"
#include "ui/scene_view/scene_panel.h"

namespace covaria::ui {
namespace {

class Look : public WindowFixture {
protected:
    void shoot(const QString& name) {
        window_->scene().view().service().wait_until_idle();
        for (int i = 0; i < 20; ++i) QTest::qWait(10);
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().toImage().save(folder.filePath(name + QStringLiteral(".png")));
    }
    void choose_theme(const char* theme) {
        window_->findChild<ThemeSwitch*>()->choose(QString::fromLatin1(theme));
    }
    QAction* tool(const QString& text) const {
        for (QAction* action : window_->findChild<QToolBar*>(QStringLiteral("tools"))->actions())
            if (action->text().remove(QLatin1Char('&')).startsWith(text)) return action;
        ADD_FAILURE() << "no tool " << text.toStdString();
        return nullptr;
    }
    static int column(const QAbstractItemModel& model, const QString& name) {
        for (int i = 0; i < model.columnCount(); ++i)
            if (model.headerData(i, Qt::Horizontal, id_role).toString() == name) return i;
        ADD_FAILURE() << "no column " << name.toStdString();
        return -1;
    }
};

TEST_F(Look, PropertiesOfEverythingAreShown) {
    open(project_copy());
    wait_until_idle();
    for (const char* theme : {"light", "dark"}) {
        choose_theme(theme);
        const Project& project = window_->document().project();
        std::vector<SetupAddress> entries{{SetupOwner::analysis, project.analyses.front().id}};
        for (const AssetEntry& asset : project.assets) entries.push_back({SetupOwner::asset, asset.id});
        for (const SetupAddress& entry : entries) {
            window_->selection().select_entry(entry);
            QTabWidget& tabs = *window_->properties().tabs();
            for (int tab = 0; tab < tabs.count(); ++tab) {
                tabs.setCurrentIndex(tab);
                shoot(QStringLiteral("properties-%1-%2-%3")
                          .arg(QString::fromStdString(entry.id), tabs.tabText(tab).toLower(),
                               QString::fromLatin1(theme)));
            }
        }
    }
}

}  // namespace
}  // namespace covaria::ui
