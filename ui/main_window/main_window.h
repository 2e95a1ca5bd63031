// The window: puts the panes together. Panes talk through Document, Selection and AnalysisRunner, not through
// the window.
#pragma once

#include <QMainWindow>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/main_window/file_actions.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/preferences.h"

class QAction;
class QDockWidget;
class QToolBar;

namespace covaria::ui {

class BudgetPage;
class ExportActions;
class FirstStepsGuide;
class HelpActions;
class ImpactActions;
class ImportActions;
class LibraryBrowser;
class LogPane;
class MiddlePages;
class ProblemsPane;
class ProjectPane;
class PropertiesPane;
class ResultsPane;
class RunActions;
class SearchActions;
class ScenePanel;
class ViewActions;
class ThemeSwitch;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(RecoveryStore store = RecoveryStore(), QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Shows what the user starts with: recovered work, the file given, or the start page.
    void begin(const QString& file);

    Document& document() { return document_; }
    AnalysisRunner& runner() { return runner_; }
    Selection& selection() { return selection_; }
    FileActions& files() { return files_; }
    ScenePanel& scene() { return *scene_; }
    ViewActions& views() { return *views_; }
    ResultsPane& results() { return *results_; }
    PropertiesPane& properties() { return *properties_; }
    BudgetPage& budget() { return *budget_; }
    ProjectPane& project_pane() { return *project_; }
    ExportActions& exports() { return *exports_; }
    HelpActions& help() { return *help_; }
    SearchActions& search() { return *search_; }
    PreferenceStore& preferences() { return preferences_; }
    void show_preferences();
    ImportActions& imports() { return *imports_; }
    ImpactActions& impact() { return *impact_; }
    /// The library, made when it is first asked for.
    LibraryBrowser& library();
    /// The first steps, made when they are first asked for.
    FirstStepsGuide& first_steps();
    void show_first_steps();

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void make_panes();
    QDockWidget* add_dock(Qt::DockWidgetArea area, const QString& title, const QString& name,
                          QWidget* content, QWidget* controls = nullptr);
    /// Puts the panes where they are at the first start.
    void arrange();
    void give_sides();
    void count_problems();
    void make_menus();
    void make_actions();
    QList<QWidget*> panes();
    void make_toolbar();
    void make_file_menu();
    void make_edit_menu();
    void make_view_menu();
    void make_help_menu();
    void connect_panes();
    void connect_middle();
    void connect_scene();
    void show_running_design(const QString& analysis, const QString& id);
    void show_project();
    void lead_from_equations_to_budget();
    void show_library();
    void connect_library();
    void hold_runs();
    void go_to(const QString& path);
    void update_title();
    /// Applies changed preferences at once, everywhere.
    void take_preferences();

    PreferenceStore preferences_;
    Document document_;
    Selection selection_;
    AnalysisRunner runner_{document_.maker()};
    FileActions files_;
    MiddlePages* pages_ = nullptr;
    ScenePanel* scene_ = nullptr;
    ViewActions* views_ = nullptr;
    BudgetPage* budget_ = nullptr;
    ProjectPane* project_ = nullptr;
    ResultsPane* results_ = nullptr;
    PropertiesPane* properties_ = nullptr;
    ProblemsPane* problems_ = nullptr;
    LogPane* log_ = nullptr;
    ExportActions* exports_ = nullptr;
    ImportActions* imports_ = nullptr;
    ImpactActions* impact_ = nullptr;
    LibraryBrowser* library_ = nullptr;
    RunActions* run_ = nullptr;
    HelpActions* help_ = nullptr;
    FirstStepsGuide* first_steps_ = nullptr;
    SearchActions* search_ = nullptr;
    ThemeSwitch* theme_ = nullptr;
    QMenu* add_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    NumberForm numbers_ = NumberForm::system;
    FontChoice font_;
    bool is_typed_ = false;     ///< the analysis being looked at
    bool has_project_ = false;  ///< false: only the start page has been shown
    QToolBar* toolbar_ = nullptr;
    QList<QDockWidget*> docks_;        ///< project, properties, problems, log
    QList<QAction*> project_actions_;  ///< enabled only with a project
};

}  // namespace covaria::ui
