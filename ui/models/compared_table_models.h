// Results before and after, and the difference of a budget.
#pragma once

#include <memory>

#include "core/result/comparison.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

using ComparisonPointer = std::shared_ptr<const ResultComparison>;

class ComparedResultsModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;

    /// Shows outputs of one group only; an empty group: all. Null empties the table.
    void set_comparison(ComparisonPointer comparison, const std::string& group, bool current);
    /// Index among the outputs compared.
    std::size_t output_of(int row) const { return shown_[static_cast<std::size_t>(row)]; }
    int row_of(std::size_t output) const;  ///< -1 when it is not shown

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    const OutputQuantity& quantity_of(std::size_t output) const;

    ComparisonPointer comparison_;
    std::vector<std::size_t> shown_;
};

class ComparedBudgetModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;

    /// Shows the comparison of one output; null empties the table.
    void set_comparison(ComparisonPointer comparison, std::size_t output, bool current);
};

}  // namespace covaria::ui
