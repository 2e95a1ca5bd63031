// The uncertainty budget of one output quantity.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/views/result_columns.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

class BudgetTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;
    /// A null result, or an output it does not have, empties the table.
    void set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output, bool current);
    /// Null for a row that is not there.
    const BudgetComponent* component(int row) const;

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    /// Words on the standard error of a Sobol index.
    QString standard_error(std::size_t row, const std::string& of_index) const;

    std::shared_ptr<const UncertaintyResult> result_;
    std::vector<BudgetPlace> places_;
};

}  // namespace covaria::ui
