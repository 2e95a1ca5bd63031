#include "ui/main_window/first_steps_guide.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QTabWidget>
#include <algorithm>

#include "ui/main_window/dock_title.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/budget_page.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/first_steps_panel.h"
#include "ui/pages/highlight_frame.h"
#include "ui/pages/page_view.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/stage.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Whether a row of the budget has a text in this section.
bool has_text(const BudgetPage& page, BudgetSheetModel::Section section) {
    const BudgetSheetModel* model = page.model();
    for (int row = 0; model && row < model->rowCount(); ++row)
        if (!model->index(row, section).data().toString().isEmpty()) return true;
    return false;
}

bool is_seen(const QWidget& in, const char* name) {
    const auto* widget = in.findChild<QWidget*>(QLatin1String(name));
    return widget && widget->isVisible();
}

}  // namespace

FirstStepsGuide::FirstStepsGuide(const Parts& parts)
    : QObject(&parts.window),
      parts_(parts),
      dock_(new QDockWidget(tr("First Steps"), &parts.window)),
      panel_(new FirstStepsPanel),
      frame_(new HighlightFrame(&parts.window)) {
    dock_->setObjectName(QStringLiteral("first_steps_dock"));
    dock_->setTitleBarWidget(new DockTitle(*dock_, nullptr));
    dock_->setWidget(panel_);
    parts_.window.addDockWidget(Qt::LeftDockWidgetArea, dock_);
    connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (!visible) frame_->surround(nullptr);
    });
    connect(panel_, &FirstStepsPanel::show_wanted, this, &FirstStepsGuide::show_step);
    connect(panel_, &FirstStepsPanel::step_changed, this, [this] { frame_->surround(nullptr); });
    connect(panel_, &FirstStepsPanel::close_wanted, dock_, &QWidget::close);
    connect_parts();
}

void FirstStepsGuide::connect_parts() {
    connect(&parts_.document, &Document::project_replaced, this, &FirstStepsGuide::start_over);
    connect(&parts_.document, &Document::project_changed, this, &FirstStepsGuide::look);
    connect(&parts_.runner, &AnalysisRunner::result_changed, this, &FirstStepsGuide::look);
    connect(&parts_.runner, &AnalysisRunner::state_changed, this, &FirstStepsGuide::look);
    connect(&parts_.selection, &Selection::analysis_changed, this, &FirstStepsGuide::look);
    connect(&parts_.results.stage(), &Stage::changed, this, &FirstStepsGuide::look);
    connect(&parts_.results.compare_tab().kept(), &KeptStates::changed, this, &FirstStepsGuide::look);
    connect(&parts_.results.report().view(), &PageView::current_page_changed, this, &FirstStepsGuide::look);
    connect(&parts_.exports, &ExportActions::finished, this,
            [this](const QString& file, const QString& problem) {
                exported_ = exported_ || (problem.isEmpty() && file.endsWith(QStringLiteral(".pdf")));
                look();
            });
}

void FirstStepsGuide::begin() {
    dock_->show();
    dock_->raise();
    look();
    panel_->setFocus();
}

StepsTaken FirstStepsGuide::taken() const {
    StepsTaken taken;
    const QString& id = parts_.selection.analysis();
    const AnalysisStatus& status = parts_.runner.status(id);
    taken.has_budget = parts_.budget.model() != nullptr;
    taken.has_quantity = has_text(parts_.budget, BudgetSheetModel::symbol);
    taken.has_statement = has_text(parts_.budget, BudgetSheetModel::stated);
    taken.has_result = taken.has_budget && status.is_of_present();
    if (const AnalysisEntry* entry = parts_.document.project().find_analysis(to_std(id))) {
        taken.has_correlation = !entry->correlations.empty();
        taken.has_requirement = !entry->requirements.empty();
    }
    taken.seen_chart = taken.has_result && is_seen(parts_.results, "contributions_chart");
    const KeptResult* kept = parts_.results.compare_tab().kept().find(id);
    taken.kept = kept && kept->state.other.empty();
    taken.seen_report = is_seen(parts_.results, "report_pages") && parts_.results.report().page_count() > 0;
    taken.exported = exported_;
    return taken;
}

/// Marks the steps that are taken now; done ones stay done, since a tab that was looked at may be left.
void FirstStepsGuide::look() {
    if (dock_->isHidden()) return;
    const StepsTaken now = taken();
    for (int step = 0; step < int(first_steps().size()); ++step)
        if (!panel_->is_done(step) && now.*first_steps()[std::size_t(step)].done)
            panel_->set_done(step, true);
}

void FirstStepsGuide::start_over() {
    exported_ = false;
    frame_->surround(nullptr);
    for (int step = 0; step < int(first_steps().size()); ++step) panel_->set_done(step, false);
    panel_->go_to(0);
}

QWidget* FirstStepsGuide::reveal_target(const FirstStep& step) {
    const QString name = QLatin1String(step.target);
    for (QWidget* widget : parts_.window.findChildren<QWidget*>(name))
        if (reveal(*widget)) return widget;
    return nullptr;
}

void FirstStepsGuide::show_step(int step) {
    const QString& analysis = parts_.selection.analysis();
    if (!analysis.isEmpty()) parts_.selection.select_entry({SetupOwner::analysis, to_std(analysis)});
    // Forms that were made anew are shown by the event loop.
    QMetaObject::invokeMethod(
        this, [this, step] { show_target(step); }, Qt::QueuedConnection);
}

void FirstStepsGuide::show_target(int step) {
    const FirstStep* shown = &first_steps()[std::size_t(step)];
    QWidget* target = reveal_target(*shown);
    panel_->set_remark({});
    for (int before = 0; !target && before < step; ++before) {
        if (panel_->is_done(before)) continue;
        shown = &first_steps()[std::size_t(before)];
        target = reveal_target(*shown);
        panel_->set_remark(
            tr("Not there yet: first step %1, %2.").arg(before + 1).arg(covaria::ui::tr(shown->title)));
    }
    if (!target) return;
    frame_->surround(target);
    QWidget* focus = shown->focus ? parts_.window.findChild<QWidget*>(QLatin1String(shown->focus)) : nullptr;
    (focus ? focus : target)->setFocus(Qt::OtherFocusReason);
}

}  // namespace covaria::ui
