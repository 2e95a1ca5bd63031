// The output quantities of a result: estimate, u, effective degrees of freedom, k, U, interval, first order
// beside.
#pragma once

#include <memory>
#include <optional>

#include "core/result/uncertainty_result.h"
#include "ui/models/column_table_model.h"
#include "ui/models/display_units.h"

namespace covaria::ui {

class ResultTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    enum class Interval { symmetric, shortest };
    using ColumnTableModel::ColumnTableModel;

    /// A null result empties the table.
    void set_result(std::shared_ptr<const UncertaintyResult> result, bool current);
    /// Shows outputs of one group only; empty: all.
    void set_group(const std::string& group);
    void set_units(const DisplayUnits& units);
    void set_digits(int digits);  ///< significant digits of uncertainties
    void set_interval(Interval interval);

    /// Index among the result's outputs.
    std::size_t output_of(int row) const { return shown_[static_cast<std::size_t>(row)]; }
    int row_of(std::size_t output) const;  ///< -1 when it is not shown

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    void rebuild();
    void add_quantity_columns(std::vector<Column>& columns) const;
    void add_result_columns(std::vector<Column>& columns) const;
    /// U with everything of a contributor held, where there are two and not too many.
    void add_contributor_columns(std::vector<Column>& columns) const;
    void add_first_order_columns(std::vector<Column>& columns) const;
    /// Where they were asked for.
    void add_second_order_columns(std::vector<Column>& columns) const;
    const OutputResult& output(std::size_t row) const { return result_->outputs[shown_[row]]; }
    const Unit& unit(std::size_t row) const { return units_.of(output(row).quantity.unit); }
    std::optional<CoverageInterval> interval_of(std::size_t row) const;
    QString value_text(std::size_t row, double value, double uncertainty) const;
    QString uncertainty_text(std::size_t row, double uncertainty) const;

    std::shared_ptr<const UncertaintyResult> result_;
    bool current_result_ = true;
    std::vector<std::size_t> shown_;
    std::string group_;
    DisplayUnits units_;
    int digits_ = 2;
    Interval interval_ = Interval::symmetric;
};

}  // namespace covaria::ui
