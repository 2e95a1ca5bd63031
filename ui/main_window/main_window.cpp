#include "ui/main_window/main_window.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMap>
#include <QMenuBar>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

#include "ui/document/item_move.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/lines_editor.h"
#include "ui/main_window/dock_title.h"
#include "ui/main_window/export_actions.h"
#include "ui/main_window/file_drops.h"
#include "ui/main_window/first_steps_guide.h"
#include "ui/main_window/help_actions.h"
#include "ui/main_window/impact_actions.h"
#include "ui/main_window/import_actions.h"
#include "ui/main_window/inquiry_scene.h"
#include "ui/main_window/middle_pages.h"
#include "ui/main_window/only_middle.h"
#include "ui/main_window/pane_keys.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/recent_recorder.h"
#include "ui/main_window/run_actions.h"
#include "ui/main_window/search_actions.h"
#include "ui/main_window/shortcut_tip.h"
#include "ui/main_window/side_widths.h"
#include "ui/main_window/step_menu.h"
#include "ui/main_window/theme_switch.h"
#include "ui/main_window/undo_action.h"
#include "ui/main_window/window_state.h"
#include "ui/pages/budget_page.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/empty_project.h"
#include "ui/pages/inspector_head.h"
#include "ui/pages/library_browser.h"
#include "ui/pages/message_panes.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/run_status.h"
#include "ui/pages/second_part.h"
#include "ui/pages/stage.h"
#include "ui/pages/start_page.h"
#include "ui/pages/study_tab.h"
#include "ui/pages/unit_button.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/scene_view/view_actions.h"
#include "ui/theme/icons.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

MainWindow::MainWindow(RecoveryStore store, QWidget* parent)
    : QMainWindow(parent), files_(document_, std::move(store), this) {
    apply_number_form(numbers_ = preferences_.now().numbers);
    theme_ = new ThemeSwitch(preferences_, this);  // first: views take their rows' height from its font
    files_.dialogs = standard_dialogs(this);
    setObjectName(QStringLiteral("MainWindow"));
    setAccessibleName(tr("Covaria"));
    setDockNestingEnabled(true);
    setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::South);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);  // tables and tabs want the width
    resize(1280, 800);
    make_panes();
    make_actions();
    make_toolbar();
    make_menus();
    results_->set_typed(is_typed_);
    connect_panes();
    for (QDockWidget* dock : docks_) dock->hide();
    scene_->set_dark(theme_->is_dark());
    results_->set_dark(theme_->is_dark());
    files_.set_autosave(preferences_.now().autosave_seconds);
    font_ = preferences_.now().font;
    update_title();
}

MainWindow::~MainWindow() = default;

void MainWindow::make_panes() {
    scene_ = new ScenePanel(runner_);
    budget_ = new BudgetPage(document_, runner_, selection_);
    scene_->put_below_equations(budget_, budget_->tools());
    connect(budget_, &BudgetPage::quantity_asked, this, &MainWindow::go_to);
    views_ = new ViewActions(document_, scene_->view(), this);
    scene_->offer_views(views_->menu());
    project_ = new ProjectPane(document_, runner_, selection_, preferences_);
    project_->confirm = [this](const QString& question, const QString& action) {
        return files_.dialogs.confirm(question, action);
    };
    results_ = new ResultsPane(document_, runner_, selection_, preferences_);
    results_->add_scene(*scene_);
    setCentralWidget(pages_ = new MiddlePages(document_, *results_));
    properties_ = new PropertiesPane(document_, runner_, selection_);
    problems_ = new ProblemsPane(document_);
    log_ = new LogPane;
    // The first row of the tree is the title of its dock.
    add_dock(Qt::LeftDockWidgetArea, tr("Project"), QStringLiteral("project"), project_)
        ->setTitleBarWidget(new QWidget);
    add_dock(Qt::RightDockWidgetArea, tr("Properties"), QStringLiteral("properties"), properties_,
             &properties_->head());
    QDockWidget* problems =
        add_dock(Qt::BottomDockWidgetArea, tr("Problems"), QStringLiteral("problems"), problems_);
    QDockWidget* log = add_dock(Qt::BottomDockWidgetArea, tr("Log"), QStringLiteral("log"), log_);
    tabifyDockWidget(problems, log);
    for (QDockWidget* dock : {problems, log}) {
        auto* button = new QToolButton;
        button->setDefaultAction(dock->toggleViewAction());
        button->setAutoRaise(true);
        statusBar()->addPermanentWidget(button);
        connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
            if (shown) dock->raise();
        });
    }
    statusBar()->addPermanentWidget(new RunStatus(document_, runner_, selection_));
    exports_ = new ExportActions(document_, runner_, files_.dialogs, this);
    imports_ = new ImportActions(document_, files_.dialogs, this);
    impact_ = new ImpactActions(*this, document_, selection_, files_);
    new FileDrops(*this, files_, *imports_);
}

QDockWidget* MainWindow::add_dock(Qt::DockWidgetArea area, const QString& title, const QString& name,
                                  QWidget* content, QWidget* controls) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setAccessibleName(title);
    dock->setTitleBarWidget(new DockTitle(*dock, controls));
    dock->setWidget(content);
    addDockWidget(area, dock);
    docks_ << dock;
    return dock;
}

void MainWindow::arrange() {
    const Qt::DockWidgetArea areas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                        Qt::BottomDockWidgetArea, Qt::BottomDockWidgetArea};
    for (int i = 0; i < docks_.size(); ++i) {
        docks_[i]->setFloating(false);
        addDockWidget(areas[i], docks_[i]);
        docks_[i]->setVisible(i < 2);  // problems and log are behind the buttons of the bottom line
    }
    tabifyDockWidget(docks_[2], docks_[3]);
    if (help_) help_->hide();
    give_sides();
    resizeDocks({docks_[2]}, {height() / 5}, Qt::Vertical);
    addToolBar(Qt::TopToolBarArea, toolbar_);
    toolbar_->show();
}

void MainWindow::give_sides() {
    resizeDocks({docks_[0], docks_[1]}, side_widths(*this), Qt::Horizontal);
}

void MainWindow::make_actions() {
    const auto say = [this](const QString& text) { statusBar()->showMessage(text, 8000); };
    undo_ = make_undo_action(document_, this, say,
                             [this](const SetupAddress& entry) { selection_.select_entry(entry); });
    redo_ = make_redo_action(document_, this, say);
    undo_->setIcon(icon(QStringLiteral("undo")));
    redo_->setIcon(icon(QStringLiteral("redo")));
    undo_->setShortcut(QKeySequence::Undo);
    redo_->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    run_ = new RunActions(document_, runner_, selection_, this);
    add_ = project_->make_add_menu(this);
    add_->menuAction()->setToolTip(tr("Add an analysis or what it uses"));
}

void MainWindow::make_toolbar() {
    toolbar_ = addToolBar(tr("Tools"));
    toolbar_->setObjectName(QStringLiteral("tools"));
    toolbar_->setAccessibleName(tr("Tools"));
    toolbar_->setIconSize({20, 20});
    toolbar_->setMovable(false);
    const QList<QList<QAction*>> groups{{files_.new_action, files_.open_action, files_.save_action},
                                        {undo_, redo_},
                                        {run_->run, run_->stop, run_->live},
                                        {exports_->document_action}};
    for (const QList<QAction*>& group : groups) {
        if (group != groups.front()) toolbar_->addSeparator();
        toolbar_->addActions(group);
        for (QAction* action : group)
            if (action != exports_->document_action) show_shortcut(action);
    }
    toolbar_->insertAction(run_->run, add_->menuAction());
    toolbar_->insertSeparator(run_->run);
    if (auto* button = qobject_cast<QToolButton*>(toolbar_->widgetForAction(add_->menuAction())))
        button->setPopupMode(QToolButton::InstantPopup);
    toolbar_->widgetForAction(add_->menuAction())->setObjectName(QStringLiteral("add_button"));
    toolbar_->widgetForAction(exports_->document_action)->setObjectName(QStringLiteral("export_pdf_button"));
    run_->run->setIconText(tr("Run"));
    exports_->document_action->setIconText(tr("Document"));
    for (QAction* worded : {add_->menuAction(), run_->run, run_->stop, run_->live, exports_->document_action})
        if (auto* button = qobject_cast<QToolButton*>(toolbar_->widgetForAction(worded)))
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    project_actions_ << exports_->document_action << exports_->pdf_action << exports_->certificate_action
                     << exports_->sheet_action;
}

void MainWindow::make_menus() {
    make_file_menu();
    make_edit_menu();
    run_->add_to(*menuBar()->addMenu(tr("&Run")));
    make_view_menu();
    make_help_menu();
}

void MainWindow::make_file_menu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    menu->addAction(files_.new_action);
    menu->addMenu(files_.make_examples_menu(this));
    menu->addAction(icon(QStringLiteral("layers")), tr("&Library and Examples …"),
                    QKeySequence(Qt::CTRL | Qt::Key_L), this, &MainWindow::show_library);
    menu->addAction(files_.open_action);
    menu->addMenu(files_.make_recent_menu(this));
    menu->addSeparator();
    menu->addActions({files_.save_action, files_.save_as_action});
    menu->addSeparator();
    menu->addActions({imports_->import_action, imports_->urdf_action, impact_->action});
    QMenu* exported = exports_->make_menu(menu);
    menu->addMenu(exported);
    menu->addSeparator();
    menu->addAction(icon(QStringLiteral("quit")), tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
    project_actions_ << files_.save_action << files_.save_as_action << exported->menuAction();
}

void MainWindow::make_edit_menu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    menu->addActions({undo_, redo_});
    menu->addMenu(make_step_menu(document_, this));
    menu->addSeparator();
    menu->addMenu(add_);
    menu->addActions({project_->duplicate_action, project_->rename_action, project_->delete_action});
    menu->addSeparator();
    results_->compare_tab().add_to(*menu);
    menu->addSeparator();
    QAction* preferences = menu->addAction(tr("Pre&ferences …"), this, &MainWindow::show_preferences);
    preferences->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
    preferences->setMenuRole(QAction::PreferencesRole);
    project_actions_ << add_->menuAction();
}

void MainWindow::make_view_menu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    menu->addAction(toolbar_->toggleViewAction());
    for (QDockWidget* dock : docks_) {
        menu->addAction(dock->toggleViewAction());
        project_actions_ << dock->toggleViewAction();
    }
    menu->addSeparator();
    (new PaneKeys(*this, [this] { return panes(); }))->add_to(*menu);
    auto* middle = new OnlyMiddle(*this, docks_);
    menu->addSeparator();
    menu->addAction(middle);
    project_actions_ << middle << menu->addAction(tr("&Reset Layout"), this, &MainWindow::arrange);
    menu->addSeparator();
    menu->addAction(icon(QStringLiteral("start")), tr("Start Page"), this, [this] { pages_->show_start(); });
    QAction* scene = menu->addAction(icon(QStringLiteral("scene")), tr("3D Scene"), this, [this] {
        pages_->show_project();
        results_->stage().show_view(scene_);
    });
    project_actions_ << scene << menu->addMenu(&views_->menu());
}

/// The panes as they stand, from the left.
QList<QWidget*> MainWindow::panes() {
    const bool on_stage = results_->isVisible();
    QList<QWidget*> all{project_, on_stage ? results_->tabs().currentWidget() : pages_->currentWidget()};
    if (QWidget* second = results_->stage().second().view()) all << second;
    all << problems_ << log_ << properties_;
    if (QWidget* help = help_ ? help_->shown_pane() : nullptr) all << help;
    return all;
}

void MainWindow::make_help_menu() {
    help_ = new HelpActions(*this, selection_, document_);
    search_ = new SearchActions(*this, document_, selection_, *results_, *properties_, *help_,
                                [this](const QString& path) { go_to(path); });
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    search_->add_to(*menu);
    menu->addAction(tr("First &Steps"), this, [this] { show_first_steps(); });
    help_->add_to(*menu);
}

void MainWindow::connect_panes() {
    connect_middle();
    // Queued: first the menu or list from which it was chosen gives the keyboard back.
    connect(project_, &ProjectPane::entry_added, properties_, &PropertiesPane::go_to_first_field,
            Qt::QueuedConnection);
    connect(project_, &ProjectPane::library_wanted, this, &MainWindow::show_library);
    connect(&selection_, &Selection::entry_changed, this, &MainWindow::lead_from_equations_to_budget,
            Qt::QueuedConnection);
    project_->is_in_scene = [this](const QString& asset) { return scene_->view().shows_asset(asset); };
    connect(project_, &ProjectPane::scene_wanted, &scene_->view(), &SceneView::show_asset);
    connect(&files_, &FileActions::project_opened, this, &MainWindow::show_project);
    const auto say = [this](const QString& text) {
        statusBar()->showMessage(text, 8000);
        log_->write(text);
    };
    connect(&files_, &FileActions::message, this, say);
    connect(exports_, &ExportActions::message, this, say);
    connect(exports_, &ExportActions::certificate_wanted, this,
            [this] { go_to(QStringLiteral("/certificate")); });
    connect(&results_->report(), &ReportPreview::in_view, exports_, &ExportActions::follow_view);
    connect(project_, &ProjectPane::message, this, say);
    connect(&results_->compare_tab(), &CompareTab::message, this, say);
    connect(imports_, &ImportActions::message, this, say);
    connect(imports_, &ImportActions::accepted, this, [this] {
        if (!has_project_) files_.new_project();
    });
    connect(imports_, &ImportActions::imported, &selection_, &Selection::select_entry);
    connect(&document_, &Document::project_changed, this, &MainWindow::hold_runs);
    connect(
        &document_, &Document::project_changed, &selection_,
        [this] { selection_.leave_what_is_gone(document_.project()); }, Qt::QueuedConnection);
    connect(&document_.unread(), &UnreadTexts::changed, this, &MainWindow::hold_runs);
    connect(&problems_->problems(), &QAbstractItemModel::modelReset, this, &MainWindow::count_problems);
    connect(&document_, &Document::modified_changed, this, &MainWindow::update_title);
    connect(&document_, &Document::file_changed, this, &MainWindow::update_title);
    connect(problems_, &ProblemsPane::place_wanted, this, &MainWindow::go_to);
    connect(problems_, &ProblemsPane::refused, this, say);
    connect(results_, &ResultsPane::place_wanted, this, &MainWindow::go_to);
    connect(properties_, &PropertiesPane::place_wanted, this, &MainWindow::go_to);
    connect(properties_, &PropertiesPane::impact_wanted, impact_, &ImpactActions::ask_about);
    connect(&selection_, &Selection::analysis_changed, this, [this](const QString& id) {
        runner_.set_focus(id);
        scene_->show_analysis(id);
        views_->set_analysis(id);
        const bool typed = budget_->model() != nullptr;
        if (std::exchange(is_typed_, typed) != typed) results_->set_typed(typed);
    });
    // Whoever picks an entry wants to see it.
    connect(&selection_, &Selection::entry_changed, pages_, &MiddlePages::show_project);
    connect(project_, &QAbstractItemView::clicked, pages_, &MiddlePages::show_project);
    connect_scene();
    show_inquiries_in_scene(*results_, *scene_);
    show_assets_in_scene(selection_, *scene_);
    const auto edit_by = [this](void (PropertiesPane::*page)()) {
        selection_.select_entry({SetupOwner::analysis, to_std(selection_.analysis())});
        docks_[1]->show();
        (properties_->*page)();
    };
    connect(&results_->study_tab(), &StudyTab::edit_wanted, this,
            [edit_by] { edit_by(&PropertiesPane::show_studies); });
    connect(&results_->design_tab(), &DesignTab::edit_wanted, this,
            [edit_by] { edit_by(&PropertiesPane::show_designs); });
    connect(&runner_.designs(), &DesignRunner::changed, this, &MainWindow::show_running_design);
    connect(theme_, &ThemeSwitch::changed, this, [this](bool dark) {
        scene_->set_dark(dark);
        results_->set_dark(dark);
    });
    connect(&preferences_, &PreferenceStore::changed, this, &MainWindow::take_preferences);
    log_->follow(runner_);
    set_rendering_log([this](const std::string& message) { log_->write(to_qt(message)); });
    for (QAction* action : project_actions_) action->setEnabled(false);
}

void MainWindow::connect_middle() {
    StartPage* start = &pages_->start();
    connect(start, &StartPage::new_wanted, &files_, &FileActions::new_project);
    connect(start, &StartPage::open_wanted, &files_, &FileActions::open);
    connect(start, &StartPage::import_wanted, imports_, &ImportActions::ask_for_file);
    connect(start, &StartPage::urdf_wanted, imports_, &ImportActions::ask_for_urdf);
    connect(start, &StartPage::template_wanted, this, [this](const AnalysisTemplate& wanted) {
        files_.new_project();
        project_->add_from_template(wanted);
    });
    connect(start, &StartPage::library_wanted, this, &MainWindow::show_library);
    connect(start, &StartPage::first_steps_wanted, this, &MainWindow::show_first_steps);
    connect(start, &StartPage::file_wanted, &files_, &FileActions::open_file);
    connect(start, &StartPage::example_wanted, &files_, &FileActions::open_example);
    const auto list_recent = [this, start] { start->set_recent_files(files_.recent_files()); };
    connect(&files_, &FileActions::recent_changed, start, list_recent);
    list_recent();
    auto* recorder =
        new RecentRecorder({document_, runner_, selection_, results_->answer(), scene_->view()}, this);
    connect(recorder, &RecentRecorder::recorded, this, list_recent);
    EmptyProject* empty = &pages_->empty();
    connect(empty, &EmptyProject::library_wanted, this, &MainWindow::show_library);
    connect(empty, &EmptyProject::analysis_wanted, project_, &ProjectPane::add_analysis);
}

void MainWindow::connect_scene() {
    connect(scene_, &ScenePanel::group_changed, &selection_, &Selection::select_group);
    connect(&selection_, &Selection::group_changed, scene_, &ScenePanel::show_group);
    connect(scene_, &ScenePanel::source_picked, this, [this](const QString& asset, const QString& field) {
        if (!field.isEmpty()) selection_.select_entry(scene_->address_in(to_std(asset)));
        selection_.select_field(field);
    });
    connect(&selection_, &Selection::field_changed, scene_, [this](const QString& field) {
        const SetupAddress& entry = selection_.entry();
        scene_->select_source(entry.owner == SetupOwner::asset ? entry.id : std::string(), to_std(field));
    });
    connect(&scene_->view(), &SceneView::item_dragged, this,
            [this](const SceneItem& item, const Eigen::Vector3d& p_W, double step) {
                move_item(document_, scene_->address_in(item.source.asset),
                          {to_qt(item.name), item.source, p_W, step});
            });
    connect(&scene_->view(), &SceneView::item_turned, this,
            [this](const SceneItem& item, const Eigen::Matrix3d& R_WF, double step) {
                turn_item(document_, scene_->address_in(item.source.asset),
                          {to_qt(item.name), item.source, R_WF, step});
            });
    connect(&scene_->view(), &SceneView::coordinates_wanted, this, [this](const SceneItem& item) {
        const SetupAddress entry = scene_->address_in(item.source.asset);
        go_to(place_of_coordinates(document_.project(), entry, item.source));
    });
    scene_->measuring().style = [this] {
        const std::optional<int> stated = document_.project().results.style.digits;
        return MeasureStyle{results_->units().units(), stated.value_or(preferences_.now().digits)};
    };
    const auto take_units = [this] {
        scene_->set_units(results_->units().units());
        budget_->set_units(results_->units().units());
        properties_->set_units(results_->units().units());
    };
    connect(&results_->digits(), &QSpinBox::valueChanged, budget_, &BudgetPage::set_digits);
    budget_->set_digits(results_->digits().value());
    connect(&document_, &Document::project_changed, this, take_units);
    connect(&preferences_, &PreferenceStore::changed, this, take_units);
    take_units();
    connect(&document_, &Document::project_changed, &scene_->measuring(), &MeasureTool::update);
    connect(&preferences_, &PreferenceStore::changed, &scene_->measuring(), &MeasureTool::update);
    connect(&scene_->view(), &SceneView::drag_started, &document_, &Document::begin_merging);
    connect(&scene_->view(), &SceneView::drag_finished, &document_, &Document::end_merging);
}

LibraryBrowser& MainWindow::library() {
    if (!library_) {
        library_ = new LibraryBrowser(this);
        connect_library();
    }
    return *library_;
}

void MainWindow::show_library() {
    library().fill();
    library_->show();
    library_->raise();
    library_->search().setFocus();
}

void MainWindow::connect_library() {
    const auto with_project = [this] {
        if (!has_project_) files_.new_project();
    };
    connect(library_, &LibraryBrowser::example_wanted, &files_, &FileActions::open_example);
    connect(library_, &LibraryBrowser::template_wanted, this, [=, this](const AnalysisTemplate& wanted) {
        with_project();
        project_->add_from_template(wanted);
    });
    connect(library_, &LibraryBrowser::asset_wanted, this, [=, this](const AssetEntry& asset) {
        with_project();
        project_->add_copy(asset);
    });
}

FirstStepsGuide& MainWindow::first_steps() {
    if (!first_steps_)
        first_steps_ =
            new FirstStepsGuide({*this, document_, runner_, selection_, *budget_, *results_, *exports_});
    return *first_steps_;
}

/// A newcomer begins with an empty project; a project that is open stays.
void MainWindow::show_first_steps() {
    if (!has_project_) files_.new_project();
    pages_->show_project();
    first_steps().begin();
}

void MainWindow::show_preferences() {
    auto* dialog = findChild<PreferencesDialog*>();
    if (!dialog) dialog = new PreferencesDialog(preferences_, this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

/// Theme and font are the switch's.
void MainWindow::take_preferences() {
    const Preferences& wanted = preferences_.now();
    files_.set_autosave(wanted.autosave_seconds);
    const bool other_numbers = wanted.numbers != numbers_;
    const bool other_font = !(std::exchange(font_, wanted.font) == wanted.font);
    if (other_numbers || other_font) finish_typing();  // typed texts have the form from before
    // Widths follow the letters as well, once all widgets have taken the font.
    if (other_font && has_project_)
        QMetaObject::invokeMethod(this, &MainWindow::give_sides, Qt::QueuedConnection);
    if (other_numbers) {
        apply_number_form(numbers_ = wanted.numbers);
        setLocale(QLocale());
    }
    results_->take_preferences();
    if (other_numbers || other_font) properties_->start_over();  // sizes of forms are those of their font
    if (!other_numbers) return;
    results_->set_dark(theme_->is_dark());
    for (auto* view : findChildren<QAbstractItemView*>()) view->viewport()->update();
}

/// Whoever starts one wants to see what it finds.
void MainWindow::show_running_design(const QString& analysis, const QString& id) {
    if (analysis != selection_.analysis() ||
        runner_.designs().status(analysis, id).state != RunState::running)
        return;
    selection_.select_design(id);
    results_->stage().show_view(&results_->design_tab());
}

void MainWindow::begin(const QString& file) {
    if (files_.offer_recovery()) return;
    if (!file.isEmpty()) files_.open_file(file);
}

void MainWindow::show_project() {
    const bool first = !std::exchange(has_project_, true);
    for (QAction* action : project_actions_) action->setEnabled(true);
    if (first) {
        arrange();
        restore_window(*this);
    }
    selection_.clear();
    budget_->start_over();
    scene_->start_over();
    results_->start_over();
    const Project& project = document_.project();
    if (!project.analyses.empty())
        selection_.select_entry({SetupOwner::analysis, project.analyses.front().id});
    else if (!project.assets.empty())
        selection_.select_entry({SetupOwner::asset, project.assets.front().id});
    update_title();
    pages_->show_project();
    if (pages_->empty().isVisible()) pages_->empty().setFocus();
}

/// Tab leads from the equations to the budget, where the quantities that they name have their rows.
void MainWindow::lead_from_equations_to_budget() {
    const auto* equations = properties_->findChild<LinesEditor*>();
    if (equations) budget_->follow_in_tab_order(*equations->text_edit());
}

/// Holds runs back, so that nothing is evaluated from an old value while a text stands in its place.
void MainWindow::hold_runs() {
    const UnreadTexts::Held held = document_.unread().held(document_.project());
    runner_.set_held(held.analyses);
    runner_.studies().set_held(held.inquiries);
    runner_.designs().set_held(held.inquiries);
}

void MainWindow::count_problems() {
    const int count = problems_->problems().rowCount();
    docks_[2]->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
}

void MainWindow::go_to(const QString& path) {
    const SetupAddress entry = address_of_path(document_.project(), to_std(path));
    if (!exists(document_.project(), entry)) return;
    selection_.select_entry(entry);
    docks_[1]->show();
    properties_->focus_field(path);
}

void MainWindow::update_title() {
    setWindowTitle(!has_project_ ? tr("Covaria[*]") : tr("%1[*] – Covaria").arg(document_.heading()));
    setWindowModified(document_.is_modified());
}

bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::ThemeChange && theme_) theme_->follow_system();
    return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_.may_leave()) {
        event->ignore();
        return;
    }
    if (has_project_) remember_window(*this);
    runner_.stop_all();
    set_rendering_log({});
    event->accept();
}

}  // namespace covaria::ui
