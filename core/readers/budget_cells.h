// The cells of a budget in a sheet, by row and by what their column means.
#pragma once

#include <optional>
#include <string>

#include "core/readers/budget_place.h"
#include "core/readers/stated_budget.h"

namespace covaria {

/// A figure with the unit that stands behind it in its cell, else in the head.
struct CellFigure {
    double value = 0.0;
    std::optional<Unit> unit = {};
};

class BudgetCells {
public:
    using Column = BudgetColumn;

    explicit BudgetCells(SheetBudget place) : place_(std::move(place)) {}

    const SheetBudget& place() const { return place_; }
    /// Of the sheet, 0 where there is none.
    int column(Column wanted) const;
    /// Null where there is no such column.
    const BudgetHead* head(Column wanted) const;
    std::optional<Unit> unit_in_head(Column wanted) const;
    const WorkbookCell* cell(int row, Column wanted) const;
    std::string text(int row, Column wanted) const;
    tl::unexpected<Error> refused(int row, Column wanted, const Message& message) const;

    /// A number, or a number with a unit behind it; empty where the cell is.
    Result<std::optional<CellFigure>> figure(int row, Column wanted) const;

    bool is_uncertain(int row) const;
    bool is_described(int row) const;
    bool has_figure(int row, Column wanted) const;

private:
    SheetBudget place_;
};

/// "15 nm", "±0.3", "1.5e-5": empty where it is none.
std::optional<CellFigure> figure_in_text(const std::string& words);

/// The uncertainty that a row states, in `unit` where its figures have none of their own; what was concluded
/// is said in `proposals`.
Result<NotedComponent> component_of(const BudgetCells& cells, int row, const Unit& unit,
                                    Proposals& proposals);

/// Error{usage}: a column that is not understood is filled in a row of the budget; words without a head
/// above them are none.
Result<void> check_no_column_is_dropped(const BudgetCells& cells);

}  // namespace covaria
