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
#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/all_results_tab.h"
#include "ui/pages/answer_strip.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/evaluation_tab.h"
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
    tabs_->addTab(results_tab_ = make_results_tab(), tr("Results"));
    tabs_->addTab(budget_tab_ = make_budget_tab(), tr("Budget"));
    tabs_->addTab(charts_tab_ = make_charts_tab(), tr("Charts"));
    auto* evaluation = new EvaluationTab(runner, selection);
    add_unoffered(*tabs_, evaluation, tr("Evaluation"));
    connect(evaluation, &EvaluationTab::filled, tabs_,
            [this, evaluation](bool any) { offer(*stage_, *tabs_, *evaluation, any); });
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

/// Adds the choice of units and of digits at the right of the filter.
void ResultsPane::add_units_and_digits(QHBoxLayout& row) {
    units_ = new UnitButton(document_, preferences_);
    digits_ = new QSpinBox;
    digits_->setRange(fewest_digits, most_digits);
    digits_->setPrefix(tr("digits of U: "));
    digits_->setAccessibleName(tr("Significant digits of uncertainties"));
    digits_->setToolTip(
        tr("Significant digits of uncertainties in the window; estimates are rounded to match. "
           "Documents have those of the project page."));
    row.addWidget(units_);
    row.addWidget(digits_);
    connect(digits_, &QSpinBox::valueChanged, this, [this](int digits) {
        result_model_.set_digits(digits);
        budget_model_.set_digits(digits);
        compare_->set_digits(digits);
        all_->set_digits(digits);
        answer_->set_digits(digits);
    });
}

QWidget* ResultsPane::make_filter() {
    auto* bar = new QWidget;
    auto* parts = new FlowLayout(bar);  // large letters put units and digits below the filter
    parts->setContentsMargins(4, 2, 4, 2);
    const auto add_part = [parts] {
        auto* part = new QWidget;
        auto* row = new QHBoxLayout(part);
        row->setContentsMargins(0, 0, 0, 0);
        parts->addWidget(part);
        return row;
    };
    QHBoxLayout* row = add_part();
    filter_ = new QLineEdit;
    filter_->setObjectName(QStringLiteral("result_filter"));
    filter_->setPlaceholderText(tr("Filter: symbol, name, group"));
    filter_->setAccessibleName(tr("Filter of the results"));
    filter_->setClearButtonEnabled(true);
    keep_placeholder(*filter_);
    filter_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    all_groups_ = new QCheckBox(tr("All groups"));
    all_groups_->setToolTip(tr("Results of all poses, points or targets, whichever is selected"));
    only_not_met_ = new QCheckBox(tr("Not met only"));
    only_not_met_->setToolTip(tr("Only results whose target uncertainty or tolerance is not met"));
    row->addWidget(filter_);
    row = add_part();
    row->addWidget(all_groups_);
    row->addWidget(only_not_met_);
    add_units_and_digits(*add_part());
    connect(filter_, &QLineEdit::textChanged, this, &ResultsPane::take_filter);
    connect(only_not_met_, &QCheckBox::toggled, this, &ResultsPane::take_filter);
    connect(all_groups_, &QCheckBox::toggled, this, [this](bool on) {
        results_->set_column_shown(0, on);  // the group
        show_group(selection_.group());
    });
    return bar;
}

void ResultsPane::take_filter() {
    result_model_.set_filter(filter_->text(), only_not_met_->isChecked());
    results_->select_row(result_model_.row_of(std::size_t(std::max(0, selection_.output()))));
}

QString ResultsPane::shown_group() const {
    return all_groups_->isChecked() ? QString() : selection_.group();
}

/// Verdicts are of the requirements as they are now.
void ResultsPane::take_requirements() {
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(selection_.analysis()));
    std::vector<RequirementResult> verdicts;
    if (result_ && entry) verdicts = judge(*result_, *entry);
    only_not_met_->setEnabled(!verdicts.empty() || only_not_met_->isChecked());
    result_model_.set_result(result_, current_, std::move(verdicts));
    answer_->take_result();
}

QWidget* ResultsPane::make_results_tab() {
    results_ = new SortableTable(result_model_, tr("results"));
    results_->setObjectName(QStringLiteral("results_table"));
    results_->set_columns(QStringLiteral("results"),
                          {QStringLiteral("Group"), QStringLiteral("Estimate (first order)"),
                           QStringLiteral("U (first order)")});
    results_->extend_menu = [this](QMenu& menu, int row) {
        const std::size_t output = result_model_.output_of(row);
        units_->add_choices(*menu.addMenu(tr("Unit")), result_->outputs[output].quantity.unit);
        QAction* shortest = menu.addAction(tr("Shortest Coverage Intervals"));
        shortest->setCheckable(true);
        shortest->setChecked(shortest_);
        connect(shortest, &QAction::toggled, this, [this](bool on) {
            shortest_ = on;
            result_model_.set_interval(on ? ResultTableModel::Interval::shortest
                                          : ResultTableModel::Interval::symmetric);
        });
    };
    connect(results_, &SortableTable::row_selected, this,
            [this](int row) { selection_.select_output(int(result_model_.output_of(row))); });
    auto* tab = new QWidget;
    auto* column = new QVBoxLayout(tab);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_filter());
    column->addWidget(results_, 1);
    return tab;
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
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(charts_);
    row->addStretch(1);
    auto* column = new QVBoxLayout(tab);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
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
        take_requirements();
    });
    connect(&selection_, &Selection::group_changed, this, &ResultsPane::show_group);
    connect(&selection_, &Selection::output_changed, this, &ResultsPane::show_output);
}

void ResultsPane::take_result() {
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    result_ = status.result;
    current_ = status.is_of_present();
    const QString said = reservation(status);
    for (SortableTable* table : {results_, budget_, correlation_}) table->set_remark(said);
    units_->set_result(result_);
    result_model_.set_group(to_std(shown_group()));
    take_requirements();
    refresh_outputs();
    show_group(selection_.group());
}

void ResultsPane::take_preferences() {
    shown_style_ = document_.project().results.style;
    // A number chosen here stays until another one is stated.
    const int stated = shown_style_.digits.value_or(preferences_.now().digits);
    if (std::exchange(stated_digits_, stated) != stated) digits_->setValue(stated);
    result_model_.set_units(units_->units());
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
        if (!shown_group().isEmpty() && to_qt(quantity.group) != shown_group()) continue;
        output->add_item(output_words(quantity.symbol, quantity.group), int(i));
    }
    output->setVisible(output->count() > 1);
}

void ResultsPane::show_group(const QString& group) {
    result_model_.set_group(to_std(shown_group()));
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
        results_->select_row(result_model_.row_of(std::size_t(output)));
    }
    budget_model_.set_result(known ? result_ : nullptr, known ? std::size_t(output) : 0, current_);
    answer_->take_result();
    refresh_charts();
}

void ResultsPane::go_to_result(const QString& analysis, const QString& group, int output) {
    selection_.select_entry({SetupOwner::analysis, to_std(analysis)});
    selection_.select_group(group);
    selection_.select_output(output);
    stage_->show_view(results_tab());
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
    stage_->show_usual(typed ? *charts_tab_ : *results_tab());
}

void ResultsPane::start_over() {
    report_->start_over();
}

void ResultsPane::set_dark(bool dark) {
    for (ChartView* chart : findChildren<ChartView*>())
        chart->set_theme(dark ? Theme::dark() : Theme::light());
}

}  // namespace covaria::ui
