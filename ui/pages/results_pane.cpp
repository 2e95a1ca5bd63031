#include "ui/pages/results_pane.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/project/stated_requirements.h"
#include "core/text/numbers.h"
#include "core/views/plots.h"
#include "ui/charts/chart_view.h"
#include "ui/document/component_source.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/all_results_tab.h"
#include "ui/pages/answer_strip.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/evaluation_tab.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/second_part.h"
#include "ui/pages/seen_tab.h"
#include "ui/pages/side_by_side.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"
#include "ui/pages/study_tab.h"
#include "ui/pages/unit_button.h"
#include "ui/run/result_words.h"
#include "ui/theme/document_language.h"
#include "ui/theme/output_words.h"
#include "ui/theme/strings.h"
#include "ui/theme/tabs.h"
#include "ui/theme/theme.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {
namespace {

/// Adds a view that some models have nothing for; it is hidden until it is offered.
void add_unoffered(QTabWidget& tabs, QWidget* view, const QString& title) {
    tabs.addTab(view, title);
    show_tab(tabs, view, false);
}
void offer(Stage& stage, QTabWidget& tabs, const QWidget& view, bool any) {
    const int tab = stage.tab_of(&view);
    tabs.setTabEnabled(tab, any);
    tabs.setTabVisible(tab, any);
    stage.second().take_names();
}

}  // namespace

ResultsPane::ResultsPane(Document& document, AnalysisRunner& runner, Selection& selection,
                         PreferenceStore& preferences, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      preferences_(preferences) {
    tabs_ = new Tabs;
    make_units_and_digits();
    outputs_ = new OutputsTab(document, selection, *units_, *digits_);
    tabs_->addTab(outputs_, tr("Results"));
    connect(outputs_, &OutputsTab::shown_group_changed, this, [this] { show_group(selection_.group()); });
    tabs_->addTab(budget_tab_ = make_budget_tab(), tr("Budget"));
    tabs_->addTab(charts_tab_ = make_charts_tab(), tr("Charts"));
    auto* evaluation = new EvaluationTab(document, runner, selection);
    add_unoffered(*tabs_, evaluation, tr("Evaluation"));
    connect(evaluation, &EvaluationTab::filled, tabs_,
            [this, evaluation](bool any) { offer(*stage_, *tabs_, *evaluation, any); });
    connect(evaluation, &EvaluationTab::place_wanted, this, &ResultsPane::place_wanted);
    seen_ = new SeenTab(document, runner, selection);
    add_unoffered(*tabs_, seen_, tr("Seen"));
    connect(seen_, &SeenTab::place_wanted, this, &ResultsPane::place_wanted);
    connect(seen_, &SeenTab::filled, tabs_, [this](bool any) { offer(*stage_, *tabs_, *seen_, any); });
    study_ = new StudyTab(document, runner, selection);
    tabs_->addTab(study_, tr("Study"));
    design_ = new DesignTab(document, runner, selection);
    tabs_->addTab(design_, tr("Design"));
    compare_ = new CompareTab(document, runner, selection);
    tabs_->addTab(compare_, tr("Compare"));
    report_ = new ReportPreview(document, runner);
    tabs_->addTab(report_, tr("Document"));
    all_ = new AllResultsTab(document, runner);
    tabs_->addTab(all_, tr("All Results"));
    connect(all_, &AllResultsTab::result_wanted, this, &ResultsPane::go_to_result);
    answer_ = new AnswerStrip(document, runner, selection, this);
    connect(answer_, &AnswerStrip::place_wanted, this, &ResultsPane::place_wanted);
    stage_ = new Stage(*tabs_);
    stage_->give_whole_stage(*report_);
    connect(stage_, &Stage::changed, this, &ResultsPane::refresh_charts);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(answer_);
    column->addWidget(stage_, 1);
    connect_selection();
    take_preferences();
    take_result();
}

void ResultsPane::make_units_and_digits() {
    units_ = new UnitButton(document_, preferences_);
    digits_ = new QSpinBox;
    digits_->setRange(fewest_digits, most_digits);
    digits_->setPrefix(tr("digits of U: "));
    digits_->setAccessibleName(tr("Significant digits of uncertainties"));
    digits_->setToolTip(
        tr("Significant digits of uncertainties in the window; estimates are rounded to match. "
           "Documents have those of the project page."));
    connect(digits_, &QSpinBox::valueChanged, this, [this](int digits) {
        outputs_->model().set_digits(digits);
        budget_model_.set_digits(digits);
        compare_->set_digits(digits);
        all_->set_digits(digits);
        answer_->set_digits(digits);
    });
}

QWidget* ResultsPane::make_budget_tab() {
    budget_ = new SortableTable(budget_model_, tr("budget"));
    budget_->set_columns(QStringLiteral("budget"), {QStringLiteral("Quantities")});
    budget_->extend_menu = [this](QMenu& menu, int row) {
        menu.addAction(tr("Go to Source"), this, [this, row] { go_to_source(row); });
    };
    connect(budget_, &SortableTable::row_activated, this, &ResultsPane::go_to_source);
    contributions_ = new ChartView;
    contributions_->setObjectName(QStringLiteral("contributions_chart"));
    connect(contributions_, &ChartView::bar_clicked, this, [this](int bar) {
        budget_->select_row(bar);
        go_to_source(bar);
    });
    QSplitter* tab = side_by_side(budget_, contributions_, 3, 2);
    widen_to_content(*tab, *budget_);
    return tab;
}

void ResultsPane::show_contributions(std::size_t output) {
    PlotSpecification plot = contribution_plot(*result_, output, language_of_window());
    // The last bar stands for all other components where there are fewer bars than rows.
    const int bars = int(plot.y.categories.size());
    contributions_->set_clickable_bars(bars - int(bars < budget_model_.rowCount()));
    show_chart(*contributions_, std::move(plot));
}

/// Leads to the source of a row of the budget shown; the bars stand in the same order.
void ResultsPane::go_to_source(int row) {
    const auto& prepared = runner_.status(selection_.analysis()).prepared;
    const BudgetComponent* component = budget_model_.component(row);
    if (!prepared || !component) return;
    const QString place = place_of_component(document_.project(), *prepared, *component);
    if (!place.isEmpty()) emit place_wanted(place);
}

/// A tab with one chart at a time, chosen from a list.
QWidget* ResultsPane::make_charts_tab() {
    auto* tab = new QWidget;
    charts_ = new QComboBox;
    charts_->setObjectName(QStringLiteral("chart_kind"));
    charts_->setAccessibleName(tr("Kind of chart"));
    charts_->setToolTip(tr("Which charts of the result are shown"));
    auto* pages = new QStackedWidget;
    const auto add = [&](QWidget* page, const QString& name) {
        pages->addWidget(page);
        charts_->addItem(name);
    };
    add(make_distributions_tab(), tr("Distributions"));
    add(make_correlation_tab(), tr("Correlation"));
    add(make_convergence_tab(), tr("Convergence"));
    auto* head = new QWidget;
    head->setObjectName(QLatin1String(SecondPart::head_of_view));
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(charts_);
    row->addStretch(1);
    auto* column = new QVBoxLayout(tab);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(head);
    column->addWidget(pages, 1);
    connect(charts_, &QComboBox::currentIndexChanged, this, [this, pages](int index) {
        pages->setCurrentIndex(index);
        refresh_charts();
    });
    return tab;
}

QWidget* ResultsPane::make_distributions_tab() {
    histogram_ = new ChartView;
    quantiles_ = new ChartView;
    return side_by_side(histogram_, quantiles_);
}

QWidget* ResultsPane::make_correlation_tab() {
    correlation_ = new SortableTable(correlation_model_, tr("correlation"));
    correlation_->setSortingEnabled(false);
    correlation_->verticalHeader()->show();
    correlation_map_ = new ChartView;
    return side_by_side(correlation_, correlation_map_);
}

QWidget* ResultsPane::make_convergence_tab() {
    convergence_ = new ChartView;
    return convergence_;
}

void ResultsPane::connect_selection() {
    const auto take = [this](const QString& id) {
        if (id == selection_.analysis()) take_result();
    };
    connect(&runner_, &AnalysisRunner::result_changed, this, take);
    connect(&runner_, &AnalysisRunner::state_changed, this, take);
    connect(&selection_, &Selection::analysis_changed, this, &ResultsPane::take_result);
    connect(&document_, &Document::project_replaced, this, [this] {
        stated_digits_ = 0;  // a number chosen beside the results was for the project before
        QMetaObject::invokeMethod(this, &ResultsPane::take_preferences, Qt::QueuedConnection);
    });
    connect(&document_, &Document::project_changed, this, [this] {
        if (!(document_.project().results.style == shown_style_)) take_preferences();
        outputs_->take_requirements();
        answer_->take_result();
    });
    connect(&selection_, &Selection::group_changed, this, &ResultsPane::show_group);
    connect(&selection_, &Selection::output_changed, this, &ResultsPane::show_output);
}

void ResultsPane::take_result() {
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    result_ = status.result;
    current_ = status.is_of_present();
    const QString said = reservation(status);
    for (SortableTable* table : {&outputs_->table(), budget_, correlation_}) table->set_remark(said);
    units_->set_result(result_);
    outputs_->set_result(result_, current_);
    refresh_outputs();
    show_group(selection_.group());
}

void ResultsPane::take_preferences() {
    shown_style_ = document_.project().results.style;
    // A number chosen here stays until another one is stated.
    const int stated = shown_style_.digits.value_or(preferences_.now().digits);
    if (std::exchange(stated_digits_, stated) != stated) digits_->setValue(stated);
    outputs_->take_units();
    budget_model_.set_units(units_->units());
    compare_->set_units(units_->units());
    all_->set_units(units_->units());
    answer_->set_units(units_->units());
    study_->show_study();
    refresh_charts();
}

/// Charts are copied and saved: each says itself when it is not the result.
void ResultsPane::show_chart(ChartView& view, PlotSpecification plot) const {
    const QString said = reservation(runner_.status(selection_.analysis()));
    if (!said.isEmpty() && !plot.series.empty()) plot.title += " \u2013 " + to_std(said);
    view.set_plot(std::move(plot));
}

void ResultsPane::refresh_outputs() {
    TypesetComboBox* output = &answer_->outputs();
    const QSignalBlocker blocker(output);
    output->clear();
    if (!result_) return output->hide();
    for (std::size_t i = 0; i < result_->outputs.size(); ++i) {
        const OutputQuantity& quantity = result_->outputs[i].quantity;
        if (!outputs_->shown_group().isEmpty() && to_qt(quantity.group) != outputs_->shown_group()) continue;
        output->add_item(output_words(quantity.symbol, quantity.group), int(i));
    }
    output->setVisible(output->count() > 1);
}

void ResultsPane::show_group(const QString& group) {
    outputs_->take_group();
    correlation_model_.set_result(result_, to_std(group), current_);
    correlation_->setVisible(correlation_model_.rowCount() > 1);
    refresh_outputs();
    const TypesetComboBox& list = answer_->outputs();
    const bool shown = selection_.output() >= 0 && list.findData(selection_.output()) >= 0;
    if (!shown && list.count() > 0) selection_.select_output(list.itemData(0).toInt());
    show_output(selection_.output());
}

void ResultsPane::show_output(int output) {
    const bool known = result_ && output >= 0 && std::size_t(output) < result_->outputs.size();
    if (known) {
        TypesetComboBox* list = &answer_->outputs();
        const QSignalBlocker blocker(list);
        list->setCurrentIndex(list->findData(output));
        outputs_->select_output(std::size_t(output));
    }
    budget_model_.set_result(known ? result_ : nullptr, known ? std::size_t(output) : 0, current_);
    answer_->take_result();
    refresh_charts();
}

void ResultsPane::go_to_result(const QString& analysis, const QString& group, int output) {
    selection_.select_entry({SetupOwner::analysis, to_std(analysis)});
    selection_.select_group(group);
    selection_.select_output(output);
    stage_->show_view(outputs_);
}

void ResultsPane::refresh_charts() {
    const int output = selection_.output();
    const bool known = result_ && output >= 0 && std::size_t(output) < result_->outputs.size();
    if (!known) {
        for (ChartView* chart : {contributions_, histogram_, quantiles_, correlation_map_, convergence_})
            chart->set_plot({});
        return;
    }
    const auto index = std::size_t(output);
    const DocumentLanguage in = language_of_window();
    if (stage_->shows(*contributions_)) show_contributions(index);
    if (stage_->shows(*histogram_)) {
        show_chart(*histogram_, histogram_plot(*result_, index, units_->units(), in));
        show_chart(*quantiles_, normal_quantile_plot(*result_, index, units_->units(), in));
    }
    if (stage_->shows(*correlation_map_))
        show_chart(
            *correlation_map_,
            correlation_plot(*result_, outputs_to_correlate(*result_, to_std(selection_.group())), in));
    if (stage_->shows(*convergence_))
        show_chart(*convergence_, convergence_plot(*result_, index, units_->units(), in));
}

void ResultsPane::add_scene(QWidget& scene) {
    stage_->add_first(scene, tr("Scene"));
}

/// Names the first view: a budget that is typed stands there in place of a scene.
void ResultsPane::set_typed(bool typed) {
    stage_->name_first(typed ? tr("Budget") : tr("Scene"));
    tabs_->setTabText(stage_->tab_of(budget_tab_), typed ? tr("Contributions") : tr("Budget"));
    stage_->second().take_names();
    stage_->show_usual(typed ? *charts_tab_ : static_cast<QWidget&>(*outputs_));
}

void ResultsPane::start_over() {
    report_->start_over();
}

void ResultsPane::set_dark(bool dark) {
    for (ChartView* chart : findChildren<ChartView*>())
        chart->set_theme(dark ? Theme::dark() : Theme::light());
}

}  // namespace covaria::ui
