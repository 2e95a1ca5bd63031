// The result as the sheet itself states it: the rows of the result and of the sums, which are computed anew.
#pragma once

#include <optional>
#include <string>

#include "core/readers/budget_cells.h"

namespace covaria {

/// Whether a label says "Combined standard uncertainty" or "Expanded uncertainty U (k = 2)" and no more: also
/// where a distribution stands beside it, such a row is no quantity. "Expanded uncertainty of the standard"
/// may be one.
bool is_row_of_sums(const std::string& label);

class SheetResult {
public:
    explicit SheetResult(const BudgetCells& cells) : cells_(cells) {}

    /// Takes the sums of a row such as "Expanded uncertainty, k = 2 | 73 nm"; false where the row says
    /// nothing of the kind.
    bool take_sums(int row);
    /// Takes the row of the result: value, and its contribution as u.
    void take_result(int row, const Unit& unit, const std::optional<CellFigure>& value);

    /// The stated result in `unit`, its own.
    StatedOutcome outcome(const Unit& unit) const;

private:
    std::optional<CellFigure> figure_of_sums(int row) const;

    const BudgetCells& cells_;
    std::optional<double> value_, k_;
    std::optional<CellFigure> u_, expanded_;
};

}  // namespace covaria
