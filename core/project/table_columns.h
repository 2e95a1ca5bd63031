// The match of the columns of a file with those of a table, and their units: "x [mm]".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/setup/setup_schema.h"

namespace covaria {

struct TableColumns {
    std::vector<std::size_t> target;  ///< index of the table's column, for each column of the file
    /// Unit of each column of the table; its default unit where the file has no column.
    std::vector<Unit> units;
};

/// Matches headers (key or title, a unit in brackets) with the columns of `table`, in any order. Optional
/// columns may be missing. Empty after an error: unknown, repeated or missing column, missing unit or one of
/// another dimension. Paths: "/columns/2". Whether a temperature stands for a difference is left to the check
/// of the set-up, which knows the remedy.
std::optional<TableColumns> match_columns(const FieldSpec& table, const std::vector<std::string>& headers,
                                          Problems& problems);

/// Index of the column with this key or title, or SetupSchema::npos.
std::size_t find_table_column(const FieldSpec& table, const std::string& name);
/// The name in a header: "x" of "x [mm]".
std::string header_name(const std::string& header);

/// The header of a column: "x [mm]" with a unit, "x" without one.
std::string column_header(const ColumnSpec& column, const Unit& unit);

}  // namespace covaria
