// The budget in the centre of the window: one table of what is stated and what comes of it.
#pragma once

#include <QWidget>
#include <memory>
#include <set>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/budget_sheet_model.h"
#include "ui/models/input_correlation_model.h"
#include "ui/run/analysis_runner.h"

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace covaria::ui {

class BudgetSheetView;

/// Budget sheet of the analysis looked at; hidden where its set-up has no table that states quantities.
class BudgetPage : public QWidget {
    Q_OBJECT
public:
    BudgetPage(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    /// Null: the analysis states its quantities otherwise.
    BudgetSheetView* view() const { return view_; }
    BudgetSheetModel* model() const { return model_.get(); }
    /// Tells the correlations, and how far the law of propagation holds.
    QLabel& remark() const { return *remark_; }
    /// The correlation coefficient of the components of the two rows that are selected.
    QLineEdit& correlation() const { return *correlation_; }
    /// Tab comes from `before` to the table, and from it to the correlation coefficient.
    void follow_in_tab_order(QWidget& before);
    /// Begins anew with another project.
    void start_over();

    void set_units(const DisplayUnits& units);
    void set_digits(int digits);  ///< significant ones of U

signals:
    /// The page of an input quantity is wanted: a JSON pointer into the project.
    void quantity_asked(const QString& path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void ask_for_quantity(int row);
    void show_analysis();
    void take_result();
    QString first_order_words(const UncertaintyResult& result) const;
    /// "r(d, theta) = 0.5" of every two rows that are correlated; empty: none are.
    QString correlation_words(const PreparedAnalysis& analysis) const;
    /// Cell of the correlation matrix for the two selected rows; invalid: there is none.
    QModelIndex selected_pair();
    std::set<int> selected_rows() const;
    void show_correlation();
    void mark_correlation(const QModelIndex& cell);
    void take_correlation();
    void ask_for_correlation();

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    QString analysis_;
    std::unique_ptr<BudgetSheetModel> model_;
    BudgetSheetView* view_ = nullptr;
    QVBoxLayout* column_ = nullptr;
    QLabel* remark_;
    InputCorrelationModel correlations_;
    QLabel* pair_ = nullptr;
    QLineEdit* correlation_ = nullptr;
    DisplayUnits units_;
    int digits_ = 2;
};

}  // namespace covaria::ui
