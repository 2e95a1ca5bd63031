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
    int match = -1;  ///< column whose number (an uncertainty in the same unit) decides the decimals in print
};

/// Nothing, a number (SI, shown in the column's unit), a text that people typed or a symbol, a number with a
/// unit of its own (budgets, whose rows have different units), or words of the program.
using TableCell = std::variant<std::monostate, double, std::string, Quantity, Message>;

/// What a cell of text or words says in English; empty for numbers.
inline std::string english_of(const TableCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    const auto* words = std::get_if<Message>(&cell);
    return words ? words->english() : std::string();
}

struct DataTable {
    std::string id;  ///< file-name friendly ("budget-x-7")
    std::string title;
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows;
    std::vector<Message> notes;
};

}  // namespace covaria
