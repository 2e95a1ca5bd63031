// The middle of the window: the answer of the analysis being looked at, and below it the stage with all its
// views: scene, results, budget, charts, evaluation, study, design, compare, document.
#pragma once

#include <QTabWidget>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/budget_table_model.h"
#include "ui/models/correlation_table_model.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/preferences.h"

class QComboBox;
class QSpinBox;

namespace covaria {
struct PlotSpecification;
}

namespace covaria::ui {

class ChartView;
class AllResultsTab;
class AnswerStrip;
class CompareTab;
class ReportPreview;
class SortableTable;
class DesignTab;
class OutputsTab;
class SeenTab;
class Stage;
class StudyTab;
class UnitButton;

class ResultsPane : public QWidget {
    Q_OBJECT
public:
    ResultsPane(Document& document, AnalysisRunner& runner, Selection& selection,
                PreferenceStore& preferences, QWidget* parent = nullptr);

    void set_dark(bool dark);
    /// Follows the preferences: units, digits and the form of numbers.
    void take_preferences();
    /// Begins anew with another project: its report has not been made.
    void start_over();
    /// Adds the first view of the stage: the scene, or what takes its place.
    void add_scene(QWidget& scene);
    /// Tells whether the analysis looked at is typed as a budget.
    void set_typed(bool typed);
    Stage& stage() { return *stage_; }
    QTabWidget& tabs() { return *tabs_; }
    QComboBox& chart_kind() { return *charts_; }
    QWidget* budget_tab() { return budget_tab_; }
    OutputsTab& outputs() { return *outputs_; }
    SortableTable& budget_table() { return *budget_; }
    UnitButton& units() { return *units_; }
    QSpinBox& digits() { return *digits_; }
    SeenTab& seen_tab() { return *seen_; }
    StudyTab& study_tab() { return *study_; }
    DesignTab& design_tab() { return *design_; }
    CompareTab& compare_tab() { return *compare_; }
    ReportPreview& report() { return *report_; }
    AllResultsTab& all_results_tab() { return *all_; }

    /// The strip above the stage.
    AnswerStrip& answer() { return *answer_; }

signals:
    /// A place in the project is wanted: a JSON pointer into it.
    void place_wanted(const QString& path);

private:
    void make_units_and_digits();
    QWidget* make_budget_tab();
    QWidget* make_charts_tab();
    QWidget* make_distributions_tab();
    QWidget* make_correlation_tab();
    QWidget* make_convergence_tab();
    void connect_selection();
    void take_result();
    void refresh_outputs();
    void show_group(const QString& group);
    void show_output(int output);
    void go_to_result(const QString& analysis, const QString& group, int output);
    void show_contributions(std::size_t output);
    void go_to_source(int row);
    void refresh_charts();
    void show_chart(ChartView& view, PlotSpecification plot) const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    PreferenceStore& preferences_;
    ResultStyle shown_style_;  ///< the project's style of results, which the tables have
    int stated_digits_ = 0;    ///< stated by project or preferences
    ResultPointer result_;
    bool current_ = true;
    BudgetTableModel budget_model_;
    CorrelationTableModel correlation_model_;

    Stage* stage_ = nullptr;
    QWidget *budget_tab_ = nullptr, *charts_tab_ = nullptr;
    QComboBox* charts_ = nullptr;
    AnswerStrip* answer_ = nullptr;
    UnitButton* units_ = nullptr;
    QSpinBox* digits_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    OutputsTab* outputs_ = nullptr;
    SortableTable *budget_ = nullptr, *correlation_ = nullptr;
    ChartView* contributions_ = nullptr;
    ChartView* histogram_ = nullptr;
    ChartView* quantiles_ = nullptr;
    ChartView* correlation_map_ = nullptr;
    ChartView* convergence_ = nullptr;
    SeenTab* seen_ = nullptr;
    StudyTab* study_ = nullptr;
    DesignTab* design_ = nullptr;
    CompareTab* compare_ = nullptr;
    AllResultsTab* all_ = nullptr;
    ReportPreview* report_ = nullptr;
};

}  // namespace covaria::ui
