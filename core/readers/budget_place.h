// Where the uncertainty budget is in a workbook.
#pragma once

#include <optional>
#include <vector>

#include "core/readers/budget_columns.h"
#include "core/readers/reader.h"
#include "core/readers/workbook.h"

namespace covaria {

/// Where the budget of a sheet is.
struct SheetBudget {
    const WorkbookSheet* sheet = nullptr;
    int head_row = 0;  ///< rows below are the budget
    std::vector<BudgetHead> heads = {};
    std::vector<int> columns = {};  ///< of the sheet, one for each head
};

/// By its row of headers; empty where there is none.
std::optional<SheetBudget> budget_in(const WorkbookSheet& sheet);

/// Of the sheet and columns that the choice states, else the only one with headers; refused where that leaves
/// none or several. `sheets` must live as long as the place.
Result<SheetBudget> budget_place(const std::vector<WorkbookSheet>& sheets, const ReadChoice& choice);

}  // namespace covaria
