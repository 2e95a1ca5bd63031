// Cells and heads of a report's tables as text; shared by all writers so that they agree.
#pragma once

#include <optional>
#include <string>

#include "core/report/report_document.h"
#include "core/text/symbol.h"

namespace covaria {

/// A table of a model, an asset or a design as it is read: the head of a column has the unit that all its
/// cells have, and what stands there as it was typed has the decimals of the number with the most.
TableBlock read_table(DataTable table, const NumberLocale& locale);

ColumnStyle style_of(const TableBlock& block, std::size_t column);
/// A row of a single text: sub-head across the table.
bool is_subhead(const TableBlock& block, std::size_t row);
/// The number a cell shows, in the unit it is shown in; empty for texts.
std::optional<double> shown_number(const TableCell& cell, const TableColumn& column);
/// Rounded as the column's style asks; symbols still as typed ("alpha_7").
std::string cell_text(const TableBlock& block, std::size_t row, std::size_t column);
/// Whether every filled cell of the column is a number: such columns are set flush right.
bool is_numeric_column(const TableBlock& block, std::size_t column);

/// Head with its symbols and its unit: "U / mm".
Text head_text(const TableColumn& column);
/// `cell_text` with its symbols, of numbers typeset: as readers of HTML and PDF see it.
Text cell_typeset(const TableBlock& block, std::size_t row, std::size_t column);

}  // namespace covaria
