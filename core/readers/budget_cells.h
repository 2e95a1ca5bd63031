// The cells of a budget in a sheet, by row and by the meaning of their column.
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
    /// The number of the column in the sheet, 0 where there is none.
    int column(Column wanted) const;
    /// The head of the column, null where there is no such column.
    const BudgetHead* head(Column wanted) const;
    std::optional<Unit> unit_in_head(Column wanted) const;
    const WorkbookCell* cell(int row, Column wanted) const;
    std::string text(int row, Column wanted) const;
    tl::unexpected<Error> refused(int row, Column wanted, const Message& message) const;

    /// The number of a cell, or a number with a unit behind it; empty where the cell is.
    Result<std::optional<CellFigure>> figure(int row, Column wanted) const;

    bool is_uncertain(int row) const;
    bool is_described(int row) const;
    bool has_figure(int row, Column wanted) const;

private:
    SheetBudget place_;
};

/// The figure in words such as "15 nm", "±0.3", "1.5e-5"; empty where they are none.
std::optional<CellFigure> figure_in_text(const std::string& words);

/// The uncertainty that a row states, in `unit` where its figures have none of their own; `proposals` says
/// what was concluded.
Result<NotedComponent> component_of(const BudgetCells& cells, int row, const Unit& unit,
                                    Proposals& proposals);

/// Refuses a sheet in which a column that is not understood is filled in a row of the budget; words without a
/// head above them do not count. Error{usage}.
Result<void> check_no_column_is_dropped(const BudgetCells& cells);

}  // namespace covaria
