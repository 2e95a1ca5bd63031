// Which column of a file is which column of a table, and in which unit: "x [mm]".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/setup/setup_schema.h"

namespace covaria {

struct TableColumns {
    std::vector<std::size_t> target;  ///< per column of the file: index of the table's column
    std::vector<Unit> units;          ///< per column of the table; default unit where the file has no column
};

/// Matches headers (key or title, a unit in brackets) with the columns of `table`, in any order. Optional
/// columns may be missing. Empty after an error: unknown, repeated or missing column, missing unit or one of
/// another dimension. Paths: "/columns/2". Whether a temperature stands for a difference is left to the check
/// of the set-up, which knows the way out.
std::optional<TableColumns> match_columns(const FieldSpec& table, const std::vector<std::string>& headers,
                                          Problems& problems);

/// Index of the column with this key or title, or SetupSchema::npos.
std::size_t find_table_column(const FieldSpec& table, const std::string& name);
/// "x [mm]" -> "x".
std::string header_name(const std::string& header);

/// "x [mm]" for a column with a unit, "x" for one without.
std::string column_header(const ColumnSpec& column, const Unit& unit);

}  // namespace covaria
