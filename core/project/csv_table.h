// Rows of a set-up table out of rows of texts, as its schema asks: for CSV files, import and paste.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/project/csv_reader.h"
#include "core/setup/setup_schema.h"

namespace covaria {

struct CsvTable {
    SetupTable table;        ///< csv_file is empty; rows with wrong cells are there with those cells empty
    std::vector<int> lines;  ///< the line in the text of each row of the table
    Problems problems;       ///< problems with their lines; messages name the column
};

/// Columns of the table with the headers that the file has for them, as in SetupTable::csv_columns.
using CsvColumns = std::vector<std::pair<std::string, std::string>>;

/// The table of a text whose first row holds headers: column keys or titles, with the unit in brackets ("x
/// [mm]"), or headers that `renamed` puts in their place. Problem: `renamed` names a header that is not
/// there.
CsvTable table_from_csv(const CsvText& csv, const FieldSpec& field, const CsvColumns& renamed = {});
/// The cells of the first row, which the text must have; separators behind the last are no columns.
std::vector<std::string> headers_of(const CsvText& csv);
/// The table of a text without headers (a block pasted from a spreadsheet), whose columns are in the order of
/// the schema, in `units`.
CsvTable table_from_csv_rows(const CsvText& csv, const FieldSpec& field, const std::vector<Unit>& units);
/// Whether the first row names a column of the table, which tells a text with headers from one without.
bool has_header(const CsvText& csv, const FieldSpec& field);

/// The bytes that the rows of one table may take. A project that is checked takes some three times as much.
inline constexpr std::size_t largest_table = 128'000'000;
/// The reason why a text of so many lines cannot become rows of this field; empty if it can.
Message too_many_rows(const FieldSpec& field, std::string_view text);

/// The table of a file, whose name the problems carry. `csv_file` of the table is left empty. A file that
/// `too_many_rows` objects to is refused before any row is kept.
CsvTable table_from_csv_file(const std::filesystem::path& file, const FieldSpec& field,
                             const CsvColumns& renamed = {});

}  // namespace covaria
