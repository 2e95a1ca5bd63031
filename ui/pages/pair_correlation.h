// The correlation coefficient of two rows of a budget, typed below it.
#pragma once

#include <QModelIndex>
#include <QWidget>
#include <set>

#include "ui/models/budget_sheet_model.h"
#include "ui/models/input_correlation_model.h"
#include "ui/run/analysis_runner.h"

class QLabel;
class QLineEdit;

namespace covaria::ui {

class BudgetSheetView;

/// "r(d, theta) =" and a field, for the components of the two rows that are selected.
class PairCorrelation : public QWidget {
    Q_OBJECT
public:
    explicit PairCorrelation(Document& document, QWidget* parent = nullptr);

    /// Looks at the rows of another sheet; null: of none.
    void follow(BudgetSheetModel* sheet, BudgetSheetView* view);
    void set_analysis(const PreparedPointer& analysis);
    QLineEdit& field() const { return *field_; }
    /// Gives the keyboard to the field; without two rows selected a tooltip says what to do.
    void ask();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Cell of the correlation matrix for the two selected rows; invalid: there is none.
    QModelIndex selected_pair();
    std::set<int> selected_rows() const;
    void show_pair();
    void mark_field(const QModelIndex& cell);
    void take();

    BudgetSheetModel* sheet_ = nullptr;
    BudgetSheetView* view_ = nullptr;
    InputCorrelationModel correlations_;
    QLabel* pair_;
    QLineEdit* field_;
};

}  // namespace covaria::ui
