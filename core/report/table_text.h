// Cells and heads of a report's tables as text; shared by all writers so that they agree.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/report/report_document.h"

namespace covaria {

ColumnStyle style_of(const TableBlock& block, std::size_t column);
/// A row of a single text: sub-head across the table.
bool is_subhead(const TableBlock& block, std::size_t row);
/// The number a cell shows, in the unit it is shown in; empty for texts.
std::optional<double> shown_number(const TableCell& cell, const TableColumn& column);
/// Rounded as the column's style asks; symbols still as typed ("alpha_7").
std::string cell_text(const TableBlock& block, std::size_t row, std::size_t column);
/// Whether every filled cell of the column is a number: such columns are set flush right.
bool is_numeric_column(const TableBlock& block, std::size_t column);

/// "U (mm)" with Unicode symbols, for plain text.
std::string head_text(const TableColumn& column);
/// "<i>U</i> (mm)": HTML, escaped.
std::string head_html(const TableColumn& column);
/// Cell as HTML, escaped; symbols with subscripts, a true minus sign.
std::string cell_html(const TableBlock& block, std::size_t row, std::size_t column);
/// Symbols among other marks ("b_1x, b_2x … b_9z"), each set as a symbol.
std::string symbols_to_html(std::string_view text);
std::string symbols_to_unicode(std::string_view text);
/// A formatted number with a true minus sign and powers of ten: "−2.3×10⁻⁵" for "-2.3e-05".
std::string typeset_number(std::string text);
/// Running text as HTML, escaped; symbols with subscripts ("u_by", "alpha_7") set as symbols.
std::string text_to_html(std::string_view text);
/// The same for an equation, where single letters and names of Greek letters are symbols as well.
std::string equation_to_html(std::string_view text);
std::string escape_html(std::string_view text);
/// Whether a title is better set as a symbol: "u_x", "x", but not "point".
bool looks_like_symbol(std::string_view title);

}  // namespace covaria
