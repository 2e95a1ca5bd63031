// Uncertainties as stated against those that the residuals of the analysis see: a table with a mark for each
// factor, the residuals, and the step that takes them over.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/jobs/latest_job.h"
#include "ui/models/seen_table_model.h"
#include "ui/run/analysis_runner.h"

class QComboBox;

namespace covaria::ui {

class ChartView;
class SortableTable;

/// Compares the stated uncertainties of the analysis looked at with what its redundant readings show, in a
/// worker thread. Models without such readings need no tab.
class SeenTab : public QWidget {
    Q_OBJECT
public:
    SeenTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    SortableTable& table() { return *table_; }
    QLabel& summary() { return *summary_; }
    QPushButton& take_over_button() { return *take_over_; }
    QComboBox& abscissa() { return *abscissa_; }
    QComboBox& shape() { return *shape_; }
    ChartView& residuals() { return *residuals_; }
    ChartView& quantiles() { return *quantiles_; }
    /// Null while they are computed, and without redundant readings.
    const std::shared_ptr<const evidence::Seen>& seen() const { return seen_; }

signals:
    /// Tells whether there is anything to show.
    void filled(bool any);
    /// The field that states a figure, or the first of its readings, is asked for.
    void place_wanted(const QString& path);

private:
    QWidget* make_head();
    QWidget* make_charts();
    void show_abscissas();
    void refresh();
    void start();
    struct Found {
        std::shared_ptr<const evidence::RedundantReadings> readings;  ///< null: there are none
        std::shared_ptr<const evidence::Seen> seen;
    };
    void show_seen(Found found);
    void go_to_source(int row);
    void show_charts();
    void show_take_over();
    void take_over();
    bool is_taken_over() const;
    double level() const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    SeenTableModel model_;
    std::shared_ptr<const PreparedAnalysis> prepared_;  ///< the analysis that was asked
    std::shared_ptr<const evidence::RedundantReadings> readings_;
    std::shared_ptr<const evidence::Seen> seen_;
    SortableTable* table_ = nullptr;
    QComboBox *level_ = nullptr, *abscissa_ = nullptr, *shape_ = nullptr;
    QPushButton* take_over_ = nullptr;
    QLabel* summary_ = nullptr;
    ChartView *residuals_ = nullptr, *quantiles_ = nullptr;
    LatestJob job_{Execution::threads};  ///< last member: its thread ends first
};

}  // namespace covaria::ui
