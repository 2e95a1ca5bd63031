// Rows of texts to the rows of a set-up table, as its schema asks: for CSV files, import and paste.
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
    std::vector<int> lines;  ///< per row of the table: its line in the text
    Problems problems;       ///< with the line; messages name the column
};

/// As SetupTable::csv_columns.
using CsvColumns = std::vector<std::pair<std::string, std::string>>;

/// The first row holds headers: column keys or titles, with the unit in brackets ("x [mm]"), or headers that
/// `renamed` puts in their place. Problem: `renamed` names a header that is not there.
CsvTable table_from_csv(const CsvText& csv, const FieldSpec& field, const CsvColumns& renamed = {});
/// The cells of the first row, which there must be; separators behind the last are no columns.
std::vector<std::string> headers_of(const CsvText& csv);
/// Without headers (a block pasted from a spreadsheet): columns in the order of the schema, in `units`.
CsvTable table_from_csv_rows(const CsvText& csv, const FieldSpec& field, const std::vector<Unit>& units);
/// Whether the first row names a column of the table: tells the two cases apart.
bool has_header(const CsvText& csv, const FieldSpec& field);

/// Bytes that the rows of one table may take. A project that is checked takes some three times as much.
inline constexpr std::size_t largest_table = 128'000'000;
/// Why a text of so many lines cannot become rows of this field; empty if it can.
Message too_many_rows(const FieldSpec& field, std::string_view text);

/// Reads a file; problems carry the file's name. `csv_file` of the table is left empty. What has
/// `too_many_rows` is refused before any row is kept.
CsvTable table_from_csv_file(const std::filesystem::path& file, const FieldSpec& field,
                             const CsvColumns& renamed = {});

}  // namespace covaria
