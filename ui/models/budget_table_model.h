// The uncertainty budget of one output quantity.
#pragma once

#include <memory>

#include "core/result/uncertainty_result.h"
#include "ui/models/column_table_model.h"
#include "ui/models/display_units.h"

namespace covaria::ui {

class BudgetTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;
    /// A null result, or an output it does not have, empties the table.
    void set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output, bool current);
    void set_units(const DisplayUnits& units);
    void set_digits(int digits);

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    void rebuild();
    void add_component_columns(std::vector<Column>& columns) const;
    void add_contribution_columns(std::vector<Column>& columns) const;
    void add_origin_columns(std::vector<Column>& columns) const;
    const BudgetRow& row_at(std::size_t row) const { return result_->budget.rows[output_][row]; }
    const BudgetComponent& component(std::size_t row) const {
        return result_->budget.components[row_at(row).component];
    }
    const Unit& component_unit(std::size_t row) const { return units_.of(component(row).unit); }
    const Unit& output_unit() const { return units_.of(result_->outputs[output_].quantity.unit); }
    QString number(double value) const;

    std::shared_ptr<const UncertaintyResult> result_;
    std::size_t output_ = 0;
    bool current_result_ = true;
    DisplayUnits units_;
    int digits_ = 2;
};

}  // namespace covaria::ui
