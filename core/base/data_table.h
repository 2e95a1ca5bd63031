// A finished table of results for people: used by asset evaluations, reports and CSV alike.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/base/message.h"
#include "core/base/unit.h"

namespace covaria {

struct TableColumn {
    std::string header;  ///< may be a symbol ("u_cal"); `is_symbol` says so
    Unit unit = {};      ///< numbers of the column are SI; writers convert to this unit
    bool is_symbol = false;
    int digits = 0;     ///< significant digits for people; 0 = writer's choice
    int decimals = -1;  ///< fixed number of decimals in the shown unit instead; -1 = none
};

/// Nothing, a number (SI, shown in the column's unit), a text, or a number with a unit of its own
/// (budgets, whose rows have different units).
using TableCell = std::variant<std::monostate, double, std::string, Quantity>;

struct DataTable {
    std::string id;  ///< file-name friendly ("budget-x-7")
    std::string title;
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows;
    std::vector<Message> notes;
};

}  // namespace covaria
