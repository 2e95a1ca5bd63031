// The cells of a table, row by row: for tests.
#pragma once

#include <vector>

#include "core/text/table.h"

namespace covaria::test {

inline std::vector<std::vector<Cell>> rows_of(const Table& table) {
    std::vector<std::vector<Cell>> rows(table.rows);
    for (std::size_t row = 0; row < table.rows; ++row)
        for (const Column& column : table.columns) rows[row].push_back(column.cell(row));
    return rows;
}

/// The number of a computed cell, SI.
inline double si_of(const Cell& cell) {
    return std::get<Measured>(cell).si;
}

}  // namespace covaria::test
