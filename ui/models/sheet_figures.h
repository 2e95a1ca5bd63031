// The figures of a result for the rows of a budget sheet: a table with a row for each of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/readable_unit.h"
#include "core/text/table.h"

namespace covaria::ui {

/// The unit in which the output's standard uncertainty by the law of propagation is read best: a prefix of
/// the one that `units` has for it.
DisplayUnits units_of_contributions(const OutputResult& output, const DisplayUnits& units);

class SheetFigures {
public:
    /// `unit_of_row` is the unit in which a row states its figures.
    explicit SheetFigures(std::function<Unit(std::size_t row)> unit_of_row)
        : unit_of_row_(std::move(unit_of_row)) {}
    SheetFigures(const SheetFigures&) = delete;
    SheetFigures& operator=(const SheetFigures&) = delete;

    /// Finds the component that each row of the set-up's table `key` states; of a chain of analyses only
    /// those of this one's set-up. Null: there is no result.
    void follow(std::shared_ptr<const UncertaintyResult> result, std::size_t output, const std::string& key);
    /// Moves computed figures with their rows: so many are inserted at `first`, or (below zero) removed.
    void move(int first, int count);
    /// Sets the units of results, in which sensitivity coefficients are.
    void set_units(const DisplayUnits& units) { units_ = units; }
    /// The component that the row states; null: none.
    const BudgetComponent* component(std::size_t row) const;
    /// The units of contributions to the result, which there must be.
    DisplayUnits units_of_contributions() const {
        return covaria::ui::units_of_contributions(result_->outputs[output_], units_);
    }
    /// A table with the keys of the budget's columns. Stated figures stay in the row's unit.
    const Table& table() const { return table_; }

private:
    void make_table();
    Cell sensitivity(std::size_t row, const BudgetComponent& component) const;
    Cell without_influence(std::string_view key, const BudgetComponent& component) const;

    std::function<Unit(std::size_t row)> unit_of_row_;
    std::shared_ptr<const UncertaintyResult> result_;
    std::size_t output_ = 0;
    DisplayUnits units_;
    Table budget_;                                        ///< the output's budget
    std::vector<std::optional<std::size_t>> lines_;       ///< line in `budget_`, for each row of the sheet
    std::vector<std::optional<std::size_t>> components_;  ///< index in the result, for each row of the sheet
    Table table_;
};

}  // namespace covaria::ui
