// The place of the uncertainty budget in a workbook.
#pragma once

#include <optional>
#include <vector>

#include "core/readers/budget_columns.h"
#include "core/readers/reader.h"
#include "core/readers/workbook.h"

namespace covaria {

/// The place of the budget in a sheet.
struct SheetBudget {
    const WorkbookSheet* sheet = nullptr;
    int head_row = 0;  ///< row of the headers, above the rows of the budget
    std::vector<BudgetHead> heads = {};
    std::vector<int> columns = {};  ///< columns of the sheet, one for each head
};

/// The budget of a sheet by its row of headers; empty where there is none.
std::optional<SheetBudget> budget_in(const WorkbookSheet& sheet);

/// The budget of the sheet and columns that the choice states, else the only one with headers; refused where
/// that leaves none or several. `sheets` must live as long as the place.
Result<SheetBudget> budget_place(const std::vector<WorkbookSheet>& sheets, const ReadChoice& choice);

}  // namespace covaria
