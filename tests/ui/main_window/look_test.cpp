// Look of the window beyond the tabs of results: properties, start page, toolbar; every picture is left in
// the build folder for people.
#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>

#include "tests/ui/main_window/window_fixture.h"
#include "ui/main_window/help_actions.h"
#include "ui/main_window/theme_switch.h"
#include "ui/models/roles.h"
#include "ui/pages/field_help.h"
#include "ui/pages/message_panes.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/question_tile.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/run_status.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/unit_button.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/fold_groups.h"

namespace covaria::ui::look_test {
namespace {

class Look : public WindowFixture {
protected:
    void shoot(const QString& name) {
        settle();
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
            FoldGroups& groups = window_->properties().groups();
            for (int group = 0; group < groups.count(); ++group) {
                window_->properties().show_group(group);
                shoot(QStringLiteral("properties-%1-%2-%3")
                          .arg(QString::fromStdString(entry.id), groups.title(group).toLower(),
                               QString::fromLatin1(theme)));
            }
        }
    }
}

TEST_F(Look, StartPageIsComposedAtEverySize) {
    QSettings().setValue(
        QStringLiteral("recentFiles"),
        QStringList{QStringLiteral(COVARIA_SOURCE_DIR "/projects/stewart-platform.covaria")});
    make_window();
    for (const char* theme : {"light", "dark"}) {
        choose_theme(theme);
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
            window_->resize(size);
            shoot(QStringLiteral("start-%1-%2").arg(size.width()).arg(QString::fromLatin1(theme)));
            const auto tiles = window_->findChildren<QuestionTile*>();
            ASSERT_EQ(tiles.size(), 5);
            for (const QuestionTile* tile : tiles) {
                const QRect place(tile->mapTo(window_.get(), QPoint()), tile->size());
                EXPECT_GE(tile->width(), tile->sizeHint().width());
                EXPECT_LE(place.right(), size.width());
            }
        }
    }
}

TEST_F(Look, ToolsAreEnabledWhereTheyCanDoSomething) {
    for (const char* name : {"Save", "Undo", "Redo", "Run", "Stop", "Report"})
        EXPECT_FALSE(tool(QString::fromLatin1(name))->isEnabled()) << name;
    for (const char* name : {"New", "Open", "Live"})
        EXPECT_TRUE(tool(QString::fromLatin1(name))->isEnabled()) << name;
    open(project_copy());
    wait_until_idle();
    for (const char* name : {"Save", "Run", "Report"})
        EXPECT_TRUE(tool(QString::fromLatin1(name))->isEnabled()) << name;
    EXPECT_FALSE(tool(QStringLiteral("Stop"))->isEnabled());
    EXPECT_FALSE(tool(QStringLiteral("Undo"))->isEnabled());
    window_->document().apply(QStringLiteral("More trials"), [](Project& project) {
        for (AnalysisEntry& analysis : project.analyses) analysis.options.trials = 500'000'000;
    });
    EXPECT_TRUE(tool(QStringLiteral("Undo"))->isEnabled());
    EXPECT_TRUE(QTest::qWaitFor([this] { return tool(QStringLiteral("Stop"))->isEnabled(); }, 30'000));
    auto* bar = window_->findChild<QToolBar*>(QStringLiteral("tools"));
    QTest::mouseClick(bar->widgetForAction(tool(QStringLiteral("Stop"))), Qt::LeftButton);
    wait_until_idle();
    EXPECT_FALSE(tool(QStringLiteral("Stop"))->isEnabled());
}

TEST_F(Look, ToolsNameTheirShortcutsAndHavePictures) {
    for (QAction* action : window_->findChild<QToolBar*>(QStringLiteral("tools"))->actions()) {
        if (action->isSeparator()) continue;
        EXPECT_FALSE(action->icon().isNull()) << action->text().toStdString();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        EXPECT_TRUE(action->toolTip().contains(keys)) << action->toolTip().toStdString();
        EXPECT_FALSE(action->toolTip().contains(QLatin1Char('&'))) << action->toolTip().toStdString();
    }
}

TEST_F(Look, LiveIsRemembered) {
    auto* bar = window_->findChild<QToolBar*>(QStringLiteral("tools"));
    QTest::mouseClick(bar->widgetForAction(tool(QStringLiteral("Live"))), Qt::LeftButton);
    EXPECT_FALSE(window_->runner().is_live());
    make_window();
    EXPECT_FALSE(window_->runner().is_live());
    EXPECT_FALSE(tool(QStringLiteral("Live"))->isChecked());
}

TEST_F(Look, ColumnsAreChosenAndRemembered) {
    open(project_copy());
    wait_until_idle();
    SortableTable& table = window_->results().outputs().table();
    const int group = column(*table.model(), QStringLiteral("Group"));
    EXPECT_TRUE(table.isColumnHidden(group)) << "one group is shown at a time";
    QMenu menu;
    table.fill_column_menu(menu);
    menu.actions()[group]->trigger();
    menu.actions()[column(*table.model(), QStringLiteral("k"))]->trigger();
    EXPECT_FALSE(table.isColumnHidden(group));
    EXPECT_TRUE(table.csv().startsWith(QStringLiteral("group,")));
    table.setColumnWidth(group, 123);
    answer_.save = SaveAnswer::discard;
    make_window();
    open(project_copy());
    wait_until_idle();
    SortableTable& again = window_->results().outputs().table();
    EXPECT_FALSE(again.isColumnHidden(group));
    EXPECT_EQ(again.columnWidth(group), 123);
    EXPECT_TRUE(again.isColumnHidden(column(*again.model(), QStringLiteral("k"))));
}

// The stage has the room; what is cut of a name stands in its tooltip. Groups without entries are not there.
TEST_F(Look, TheTreeIsNarrowAndItsNamesAreWholeInTheirTooltips) {
    auto* tree = window_->findChild<ProjectPane*>();
    ASSERT_TRUE(tree);
    for (const char* name : {"force-moment-sensor", "lsm-network"}) {
        open(project_copy(QString::fromLatin1(name)));
        wait_until_idle();
        settle();
        EXPECT_NEAR(tree->width(), 184, 4);
        EXPECT_NEAR(window_->properties().width(), 296, 4) << "in a window of 1280 px";
        const QAbstractItemModel& model = *tree->model();
        for (int category = 1; category < model.rowCount(); ++category) {  // the first is the project
            const QModelIndex above = model.index(category, 0);
            EXPECT_EQ(tree->isRowHidden(category, {}), model.rowCount(above) == 0);
            for (int row = 0; row < model.rowCount(above); ++row) {
                const QModelIndex entry = model.index(row, 0, above);
                EXPECT_EQ(tree->visualRect(entry).height(), 24);
                EXPECT_TRUE(entry.data(Qt::ToolTipRole).toString().contains(entry.data().toString()))
                    << entry.data().toString().toStdString();
            }
            if (model.rowCount(above) > 0) {
                EXPECT_EQ(tree->visualRect(above).height(), 28);
            }
        }
    }
    tree->resize(60, tree->height());
    EXPECT_TRUE(tree->isColumnHidden(1)) << "icons only";
}

// A table with other columns than before: what appears in the place of a hidden one is fitted as well.
TEST_F(Look, OnlyWidthsThatTheUserGaveAreRemembered) {
    for (const char* name : {"chain", "stewart-platform"}) {
        open(project_copy(QString::fromLatin1(name)));
        wait_until_idle();
        for (const AnalysisEntry& analysis : window_->document().project().analyses)
            window_->selection().select_entry({SetupOwner::analysis, analysis.id});
    }
    for (const QString& key : QSettings().allKeys())
        EXPECT_FALSE(key.endsWith(QLatin1String("/widths")))
            << key.toStdString() << QSettings().value(key).toMap().firstKey().toStdString();
}

TEST_F(Look, UnitsAreChosenForTablesAndChartsAndRemembered) {
    open(project_copy());
    wait_until_idle();
    const QAbstractItemModel& model = *window_->results().outputs().table().model();
    const auto cell = [&](const char* name) {
        return model.index(0, column(model, QString::fromLatin1(name))).data().toString();
    };
    ASSERT_EQ(cell("Unit"), QStringLiteral("mm"));
    const double in_mm = cell("u").toDouble();
    QMenu menu;
    window_->results().units().add_choices(menu, Unit::of("mm"));
    for (QAction* action : menu.actions())
        if (action->text() == QStringLiteral("µm")) action->trigger();
    EXPECT_EQ(cell("Unit"), QStringLiteral("µm"));
    EXPECT_NEAR(cell("u").toDouble(), 1000.0 * in_mm, 10.0);
    EXPECT_NEAR(cell("u").toDouble() / 1000.0, in_mm, 0.5e-2);
    const QAbstractItemModel& budget = *window_->results().budget_table().model();
    const int contribution = column(budget, QStringLiteral("|c|·u"));
    EXPECT_EQ(budget.headerData(contribution, Qt::Horizontal).toString(), QStringLiteral("|c|·u / µm"));
    make_window();
    EXPECT_EQ(window_->results().units().units().of(Unit::of("mm")), Unit::of("um"));
    window_->results().units().clear();
    EXPECT_EQ(window_->results().units().units().of(Unit::of("mm")), Unit::of("mm"));
}

TEST_F(Look, ProblemsAreCountedOnTheirTab) {
    open(project_copy());
    wait_until_idle();
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("problems"));
    const QString before = dock->windowTitle();
    window_->document().apply(QStringLiteral("Break"), [](Project& project) {
        project.analyses.front().options.coverage_probability = 2.0;
    });
    EXPECT_TRUE(QTest::qWaitFor([&] { return dock->windowTitle() != before; }, 30'000));
    EXPECT_TRUE(dock->windowTitle().contains(QStringLiteral("(1"))) << dock->windowTitle().toStdString();
}

TEST_F(Look, StatusBarSaysHowTheAnalysisStands) {
    open(project_copy());
    wait_until_idle();
    const auto* status = window_->statusBar()->findChild<RunStatus*>();
    ASSERT_NE(status, nullptr);
    EXPECT_GE(status->minimumHeight(), status->findChild<QToolButton*>()->sizeHint().height())
        << "a run, which shows its button, does not move the scene";
    EXPECT_TRUE(status->words().contains(QStringLiteral("up to date"))) << status->words().toStdString();
    const AnalysisEntry& analysis = window_->document().project().analyses.front();
    EXPECT_TRUE(status->words().startsWith(QString::fromStdString(analysis.name)));
}

TEST_F(Look, DocksComeBackWhereTheyWere) {
    open(project_copy());
    wait_until_idle();
    auto* toolbar = window_->findChild<QToolBar*>(QStringLiteral("tools"));
    auto* project = window_->findChild<QDockWidget*>(QStringLiteral("project"));
    window_->removeToolBar(toolbar);
    window_->addToolBar(Qt::LeftToolBarArea, toolbar);
    toolbar->show();
    project->close();
    window_->close();
    make_window();
    open(project_copy());
    EXPECT_TRUE(window_->findChild<QDockWidget*>(QStringLiteral("project"))->isHidden());
    EXPECT_EQ(window_->toolBarArea(window_->findChild<QToolBar*>(QStringLiteral("tools"))),
              Qt::LeftToolBarArea);
    for (QAction* action : window_->findChildren<QAction*>())
        if (action->text() == QStringLiteral("&Reset Layout")) action->trigger();
    EXPECT_FALSE(window_->findChild<QDockWidget*>(QStringLiteral("project"))->isHidden());
}

TEST_F(Look, HelpAndAboutCanBeRead) {
    open(project_copy());
    wait_until_idle();
    for (const char* theme : {"light", "dark"}) {
        choose_theme(theme);
        for (QAction* action : window_->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(Qt::Key_F1)) action->trigger();
        auto* page = window_->findChild<QTextBrowser*>(QStringLiteral("help"));
        ASSERT_NE(page, nullptr);
        EXPECT_GT(page->toPlainText().size(), 500);
        EXPECT_FALSE(page->toPlainText().contains(QStringLiteral("z_b"))) << "symbols are typeset";
        QCoreApplication::processEvents();
        page->window()->grab().save(
            QStringLiteral(COVARIA_BINARY_DIR "/screenshots/help-%1.png").arg(QString::fromLatin1(theme)));
        page->window()->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    for (const char* name : {"Covaria ", "Qt 6", "VTK 9", "Eigen 3"})
        EXPECT_TRUE(about_text().contains(QString::fromLatin1(name))) << about_text().toStdString();
}

TEST_F(Look, ProblemsAreListedWithPlaceAndSeverity) {
    open(project_copy());
    wait_until_idle();
    window_->document().apply(QStringLiteral("Break"), [](Project& project) {
        project.analyses.front().options.coverage_probability = 2.0;
        project.analyses.back().setup.values.erase("base_points");
    });
    wait_until_idle();
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("problems"));
    dock->raise();
    shoot(QStringLiteral("problems"));
    window_->findChild<QDockWidget*>(QStringLiteral("log"))->raise();
    shoot(QStringLiteral("log"));
    EXPECT_GT(window_->findChild<ProblemsPane*>()->model()->rowCount(), 0);
}

TEST_F(Look, TheHelpOfTheFocusedFieldIsShown) {
    open(project_copy());
    wait_until_idle();
    window_->activateWindow();
    auto* help = window_->properties().findChild<FieldHelp*>();
    ASSERT_NE(help, nullptr);
    auto* field = window_->properties().findChild<QLineEdit*>(QStringLiteral("base_u_x"));
    ASSERT_NE(field, nullptr);
    QApplication::setActiveWindow(window_.get());
    field->setFocus();
    EXPECT_TRUE(help->text().contains(field->accessibleName())) << help->text().toStdString();
    EXPECT_TRUE(help->text().contains(field->toolTip().section(QLatin1Char(' '), 0, 2).toHtmlEscaped()));
}

TEST_F(Look, ColoursOfTheSystemComeBackAfterDarkOnes) {
    choose_theme("dark");
    make_window();
    auto* theme = window_->findChild<ThemeSwitch*>();
    EXPECT_TRUE(theme->is_dark());
    theme->choose(QStringLiteral("system"));
    EXPECT_FALSE(theme->is_dark()) << "the palette of this platform is light";
    EXPECT_FALSE(system_is_dark());
    theme->choose(QStringLiteral("light"));
}

TEST_F(Look, AnEmptyProjectSaysWhatToDo) {
    window_->files().new_project();
    wait_until_idle();
    shoot(QStringLiteral("new-project"));
    EXPECT_FALSE(tool(QStringLiteral("Run"))->isEnabled());
}

/// A name for screen readers: given, or the text the control shows.
QString name_of(const QWidget& widget) {
    if (!widget.accessibleName().isEmpty()) return widget.accessibleName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    return {};
}

TEST_F(Look, EveryControlHasANameForScreenReaders) {
    open(project_copy());
    wait_until_idle();
    const Project& project = window_->document().project();
    std::vector<SetupAddress> entries{{SetupOwner::analysis, project.analyses.front().id}};
    for (const AssetEntry& asset : project.assets) entries.push_back({SetupOwner::asset, asset.id});
    QStringList nameless;
    int checked = 0;
    for (const SetupAddress& entry : entries) {
        window_->selection().select_entry(entry);
        for (const QWidget* widget : window_->findChildren<QWidget*>()) {
            const bool control =
                qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
                qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
            const QString name = widget->objectName();
            const bool inner = name.startsWith(QStringLiteral("qt_")) ||
                               name == QStringLiteral("ScrollLeftButton") ||
                               name == QStringLiteral("ScrollRightButton") ||
                               qobject_cast<const QComboBox*>(widget->parentWidget()) ||
                               widget->parentWidget()->inherits("QComboBoxPrivateContainer") ||
                               widget->inherits("QTableCornerButton") ||
                               widget->inherits("QLineEditIconButton") || widget->inherits("QHeaderView");
            if (!control || inner) continue;
            ++checked;
            if (name_of(*widget).isEmpty())
                nameless << QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') + name +
                                QStringLiteral(" in ") +
                                QString::fromLatin1(widget->parentWidget()->metaObject()->className());
        }
    }
    EXPECT_GT(checked, 100);
    nameless.removeDuplicates();
    EXPECT_TRUE(nameless.isEmpty()) << nameless.join(QLatin1Char('\n')).toStdString();
}

}  // namespace
}  // namespace covaria::ui::look_test
