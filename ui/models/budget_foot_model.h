// The result below a budget, in the columns of its sheet: y and its unit, U, nu_eff, and the u that the
// contributions add up to.
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>

#include "core/result/uncertainty_result.h"
#include "core/text/table.h"

namespace covaria::ui {

/// One row with the sections of BudgetSheetModel; none without a result.
class BudgetFootModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    /// A null result, or an output it does not have, leaves no row. u is that of the law of propagation,
    /// which the columns above are about.
    void set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output, bool current,
                    const DisplayUnits& units, int digits);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    /// The row has no number.
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// Text of a section; empty: it says nothing of the result.
    Text text_of(int section) const;
    Text stated() const;

    std::shared_ptr<const UncertaintyResult> result_;
    std::size_t output_ = 0;
    Table table_;
    DisplayUnits units_, units_of_contributions_;
    int digits_ = 2;
    bool current_ = true;
};

}  // namespace covaria::ui
