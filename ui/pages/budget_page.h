// The budget in the centre of the window: one table of what is stated and what comes of it.
#pragma once

#include <QWidget>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/models/budget_foot_model.h"
#include "ui/models/budget_sheet_model.h"
#include "ui/pages/pair_correlation.h"
#include "ui/run/analysis_runner.h"

class QLabel;
class QVBoxLayout;

namespace covaria::ui {

class BudgetFoot;
class BudgetSheetView;

/// Budget sheet of the analysis looked at; hidden where its set-up has no table that states quantities.
class BudgetPage : public QWidget {
    Q_OBJECT
public:
    BudgetPage(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent = nullptr);

    /// Null: the analysis states its quantities otherwise.
    BudgetSheetView* view() const { return view_; }
    BudgetSheetModel* model() const { return model_.get(); }
    /// The result's line below the rows; null where `view` is.
    BudgetFoot* foot() const { return foot_; }
    /// Tells the correlations, and how far the law of propagation holds.
    QLabel& remark() const { return *remark_; }
    /// Place of the buttons for rows, in the head of the budget.
    QWidget& tools() const { return *tools_; }
    /// The correlation coefficient of the components of the two rows that are selected.
    QLineEdit& correlation() const { return pair_->field(); }
    /// Tab comes from `before` to the table, and from it to the correlation coefficient.
    void follow_in_tab_order(QWidget& before);
    /// Begins anew with another project.
    void start_over();

    void set_units(const DisplayUnits& units);
    void set_digits(int digits);  ///< significant ones of U

signals:
    /// The page of an input quantity is wanted: a JSON pointer into the project.
    void quantity_asked(const QString& path);

private:
    void ask_for_quantity(int row);
    void show_analysis();
    void clear();
    void take_result();
    QString first_order_words(const UncertaintyResult& result) const;
    /// "r(d, theta) = 0.5" of every two rows that are correlated; empty: none are.
    QString correlation_words(const PreparedAnalysis& analysis) const;

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    QString analysis_;
    std::unique_ptr<BudgetSheetModel> model_;
    BudgetFootModel result_row_;
    BudgetSheetView* view_ = nullptr;
    BudgetFoot* foot_ = nullptr;  ///< the result below the rows
    QVBoxLayout* column_ = nullptr;
    QWidget* tools_;  ///< empty where `view` is null
    QLabel* remark_;
    PairCorrelation* pair_ = nullptr;
    DisplayUnits units_;
    int digits_ = 2;
};

}  // namespace covaria::ui
