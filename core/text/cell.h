// The one place that writes a cell of a table for people: the window, the budget sheet, print, HTML,
// Markdown.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// Units, digits and language in which a view shows a table.
struct TableView {
    DisplayUnits units = {};
    int digits = 2;  ///< significant digits of uncertainties
    DocumentLanguage language = {};
};

/// A cell, rounded by the rule of its column and typeset; the program's words in the view's language.
Text written(const Table& table, const Column& column, std::size_t row, const TableView& view);
/// The number of a cell, rounded as in `written`, with a plain minus sign and exponent; a sign of the unit
/// behind it where `written` has one. Nothing for other cells.
std::optional<std::string> rounded(const Table& table, const Column& column, std::size_t row,
                                   const TableView& view);
/// Head in the window, with its unit: "|c|·u / mm".
Text head_written(const Column& column, const TableView& view);
/// The same under another title.
Text head_written(const Text& title, const Column& column, const TableView& view);

/// A number as a view shows it; nothing for other cells.
std::optional<double> number_in(const Cell& cell, const DisplayUnits& units = {});
/// The number with all its digits, for programs: in the unit, or in per cent, that the head says.
std::optional<double> exact_number(const Column& column, std::size_t row, const DisplayUnits& units = {});
/// Whether every filled cell of the column is a number: print sets it flush right.
bool has_only_numbers(const Table& table, const Column& column);

/// Form of all numbers of a column in this unit, which are read against each other.
NumberForm form_of(const Table& table, const Column& column, const Unit& unit, const TableView& view);

/// "a, b, c" or, if longer than `most`, "a, b … z (117)".
std::string short_list(const std::vector<std::string>& items, std::size_t most = 3);

/// A table of a model, an asset or a design as people read it: what is zero but for rounding is shown as
/// zero, the head of a column has the unit that all its cells have, numbers that are read against each other
/// share their decimals. Title and heads are said in `in`.
Table evaluation_table(Table table, const DocumentLanguage& in);

}  // namespace covaria
