#include "ui/pages/results_pane.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/project/stated_requirements.h"
#include "core/report/plots.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"
#include "ui/charts/chart_view.h"
#include "ui/document/component_source.h"
#include "ui/document/missing_fields.h"
#include "ui/document/setup_address.h"
#include "ui/forms/form_labels.h"
#include "ui/models/problems_model.h"
#include "ui/pages/all_results_tab.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/design_tab.h"
#include "ui/pages/evaluation_tab.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/side_by_side.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/study_tab.h"
#include "ui/pages/unit_button.h"
#include "ui/run/result_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/output_words.h"
#include "ui/theme/strings.h"
#include "ui/theme/tabs.h"
#include "ui/theme/theme.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {
ResultsPane::ResultsPane(Document& document, AnalysisRunner& runner, Selection& selection,
                         PreferenceStore& preferences, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      preferences_(preferences) {
    tabs_ = new Tabs;
    tabs_->addTab(make_results_tab(), tr("Results"));
    tabs_->addTab(make_budget_tab(), tr("Budget"));
    tabs_->addTab(make_distributions_tab(), tr("Distributions"));
    tabs_->addTab(make_correlation_tab(), tr("Correlation"));
    tabs_->addTab(make_convergence_tab(), tr("Convergence"));
    auto* evaluation = new EvaluationTab(runner, selection);
    tabs_->addTab(evaluation, tr("Evaluation"));
    show_tab(*tabs_, evaluation, false);
    connect(evaluation, &EvaluationTab::filled, tabs_,
            [this, evaluation](bool any) { show_tab(*tabs_, evaluation, any); });
    study_ = new StudyTab(document, runner, selection);
    tabs_->addTab(study_, tr("Study"));
    design_ = new DesignTab(document, runner, selection);
    tabs_->addTab(design_, tr("Design"));
    compare_ = new CompareTab(document, runner, selection);
    tabs_->addTab(compare_, tr("Compare"));
    report_ = new ReportPreview(document, runner);
    tabs_->addTab(report_, tr("Report"));
    all_ = new AllResultsTab(document, runner);
    tabs_->addTab(all_, tr("All Results"));
    connect(all_, &AllResultsTab::result_wanted, this, &ResultsPane::go_to_result);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    make_head();
    column->addWidget(tabs_, 1);
    connect_selection();
    take_preferences();
    connect(tabs_, &QTabWidget::currentChanged, this, &ResultsPane::refresh_charts);
    take_result();
}

void ResultsPane::make_head() {
    head_ = new QWidget(this);
    auto* row = new QHBoxLayout(head_);
    row->setContentsMargins(0, 0, 0, 0);
    state_ = new ElidedLabel;
    units_ = new UnitButton(document_, preferences_);
    output_ = new TypesetComboBox;
    output_->setToolTip(tr("Output quantity of the budget and the charts"));
    output_->setAccessibleName(tr("Output quantity"));
    narrow_if_need_be(*output_);
    digits_ = new QSpinBox;
    digits_->setRange(fewest_digits, most_digits);
    digits_->setPrefix(tr("digits of U: "));
    digits_->setAccessibleName(tr("Significant digits of uncertainties"));
    digits_->setToolTip(
        tr("Significant digits of uncertainties in the window; estimates are rounded to match. "
           "Documents have those of the project page."));
    next_ = new QPushButton;
    next_->setObjectName(QStringLiteral("next_step"));
    next_->setAccessibleName(tr("Next step"));
    next_->hide();
    connect(next_, &QPushButton::clicked, this, [this] { emit place_wanted(next_place_); });
    row->addWidget(next_);
    row->addWidget(state_, 1);
    row->addWidget(output_);
    row->addWidget(units_);
    row->addWidget(digits_);
    connect(output_, &QComboBox::activated, this,
            [this](int index) { selection_.select_output(output_->itemData(index).toInt()); });
    connect(digits_, &QSpinBox::valueChanged, this, [this](int digits) {
        result_model_.set_digits(digits);
        budget_model_.set_digits(digits);
        compare_->set_digits(digits);
        all_->set_digits(digits);
    });
}

QWidget* ResultsPane::make_filter() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(4, 2, 4, 2);
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
    row->addWidget(all_groups_);
    row->addWidget(only_not_met_);
    row->addStretch(1);
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
    // Where there are fewer than rows, the last is that of all others.
    const int bars = int(plot.y.categories.size());
    contributions_->set_clickable_bars(bars - int(bars < budget_model_.rowCount()));
    show_chart(*contributions_, std::move(plot));
}

/// Of a row of the budget shown; the bars stand in the same order.
void ResultsPane::go_to_source(int row) {
    const auto& prepared = runner_.status(selection_.analysis()).prepared;
    const BudgetComponent* component = budget_model_.component(row);
    if (!prepared || !component) return;
    const QString place = place_of_component(document_.project(), *prepared, *component);
    if (!place.isEmpty()) emit place_wanted(place);
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
        stated_digits_ = 0;  // what was chosen beside the results was for the project before
        QMetaObject::invokeMethod(this, &ResultsPane::take_preferences, Qt::QueuedConnection);
    });
    connect(&document_, &Document::project_changed, this, [this] {
        if (!(document_.project().results.style == shown_style_)) take_preferences();
        take_requirements();
    });
    connect(&document_, &Document::problems_changed, this, &ResultsPane::show_state);
    connect(&selection_, &Selection::group_changed, this, &ResultsPane::show_group);
    connect(&selection_, &Selection::output_changed, this, &ResultsPane::show_output);
}

QString ResultsPane::state_words() const {
    if (selection_.analysis().isEmpty()) return tr("Select an analysis to see its results.");
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    if (status.state == RunState::failed) return tr("Failed: %1").arg(status.message);
    if (status.state == RunState::incomplete) {
        const QString missing = ProblemsModel::missing_words(document_, to_std(selection_.analysis()));
        return missing.isEmpty() ? tr("Not complete yet: nothing is wrong.")
                                 : tr("Not complete yet, but not wrong; to give next: %1").arg(missing);
    }
    if (!status.result)
        return status.prepared ? tr("Not evaluated yet: press F5.") : tr("The analysis has problems.");
    QString words = result_words(status);
    if (status.is_of_present() && !status.is_current())
        words = QStringLiteral("<b>%1</b>").arg(words) +
                (status.state == RunState::running ? tr("; running") : tr("; press F5 for the result"));
    if (status.result->failed_trials > 0)
        words += tr("; %1 trials without a value").arg(to_qt(count_text(status.result->failed_trials)));
    if (!represents_measurand(*status.result))
        words =
            tr("<b>Does not represent the measurand</b> (more than 1 % of the trials are lost). ") + words;
    if (!status.result->stabilised) words += tr("; not stabilised");
    // A preview is of a moment ago while something is dragged, and there is a next one at once.
    const bool is_followed = runner_.is_live() && status.stage != ResultStage::complete && status.prepared;
    if (!status.is_of_present() && !is_followed)
        words = tr("<b>Out of date</b>: shown for the project as it was. ") + words;
    return words;
}

void ResultsPane::take_result() {
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    result_ = status.result;
    current_ = status.is_of_present();
    const QString said = reservation(status);
    for (SortableTable* table : {results_, budget_, correlation_}) table->set_remark(said);
    show_state();
    units_->set_result(result_);
    result_model_.set_group(to_std(shown_group()));
    take_requirements();
    refresh_outputs();
    show_group(selection_.group());
}

void ResultsPane::show_state() {
    state_->setText(state_words());
    state_->setToolTip(state_->text());
    show_next_step();
}

void ResultsPane::show_next_step() {
    const QString& id = selection_.analysis();
    std::optional<MissingField> missing;
    if (!id.isEmpty() && runner_.status(id).state == RunState::incomplete) {
        const Project& project = document_.project();
        missing = next_missing(project, document_.problems(),
                               entry_path(project, {SetupOwner::analysis, to_std(id)}));
    }
    next_->setVisible(missing.has_value());
    if (!missing) return;
    next_place_ = to_qt(missing->path);
    next_->setText(tr("Next: %1").arg(core_text(missing->title)));
    next_->setToolTip(tr("Goes to the field that must be given next"));
}

void ResultsPane::take_preferences() {
    shown_style_ = document_.project().results.style;
    // What was chosen here stays until another number is stated.
    const int stated = shown_style_.digits.value_or(preferences_.now().digits);
    if (std::exchange(stated_digits_, stated) != stated) digits_->setValue(stated);
    result_model_.set_units(units_->units());
    budget_model_.set_units(units_->units());
    compare_->set_units(units_->units());
    all_->set_units(units_->units());
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
    const QSignalBlocker blocker(output_);
    output_->clear();
    output_->setEnabled(result_ != nullptr);
    if (!result_) return;
    for (std::size_t i = 0; i < result_->outputs.size(); ++i) {
        const OutputQuantity& quantity = result_->outputs[i].quantity;
        if (!shown_group().isEmpty() && to_qt(quantity.group) != shown_group()) continue;
        output_->add_item(output_words(quantity.symbol, quantity.group), int(i));
    }
}

void ResultsPane::show_group(const QString& group) {
    result_model_.set_group(to_std(shown_group()));
    correlation_model_.set_result(result_, to_std(group), current_);
    correlation_->setVisible(correlation_model_.rowCount() > 1);
    refresh_outputs();
    const bool shown = selection_.output() >= 0 && output_->findData(selection_.output()) >= 0;
    if (!shown && output_->count() > 0) selection_.select_output(output_->itemData(0).toInt());
    show_output(selection_.output());
}

void ResultsPane::show_output(int output) {
    const bool known = result_ && output >= 0 && std::size_t(output) < result_->outputs.size();
    if (known) {
        const QSignalBlocker blocker(output_);
        output_->setCurrentIndex(output_->findData(output));
        results_->select_row(result_model_.row_of(std::size_t(output)));
    }
    budget_model_.set_result(known ? result_ : nullptr, known ? std::size_t(output) : 0, current_);
    refresh_charts();
}

void ResultsPane::go_to_result(const QString& analysis, const QString& group, int output) {
    selection_.select_entry({SetupOwner::analysis, to_std(analysis)});
    selection_.select_group(group);
    selection_.select_output(output);
    tabs_->setCurrentIndex(0);
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
    const QWidget* shown = tabs_->currentWidget();
    const DocumentLanguage in = language_of_window();
    if (shown->isAncestorOf(contributions_)) show_contributions(index);
    if (shown->isAncestorOf(histogram_)) {
        show_chart(*histogram_, histogram_plot(*result_, index, units_->units(), in));
        show_chart(*quantiles_, normal_quantile_plot(*result_, index, units_->units(), in));
    }
    if (shown->isAncestorOf(correlation_map_))
        show_chart(
            *correlation_map_,
            correlation_plot(*result_, outputs_to_correlate(*result_, to_std(selection_.group())), in));
    if (shown == convergence_)
        show_chart(*convergence_, convergence_plot(*result_, index, units_->units(), in));
}

void ResultsPane::start_over() {
    report_->start_over();
}

void ResultsPane::set_dark(bool dark) {
    for (ChartView* chart : findChildren<ChartView*>())
        chart->set_theme(dark ? Theme::dark() : Theme::light());
}

}  // namespace covaria::ui
