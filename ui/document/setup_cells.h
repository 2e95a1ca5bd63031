// Cells and values of a set-up as text, and back.
#pragma once

#include <QLocale>
#include <QString>

#include "core/setup/setup_schema.h"

namespace covaria::ui {

/// Titles of a column's choices as people read them: translated, but for the names of a project's assets.
QStringList choice_words(const ColumnSpec& column);

/// Text that a cell shows: choices by title, numbers in the locale's writing without their unit.
QString cell_text(const ColumnSpec& column, const SetupCell& cell, const QLocale& locale);

/// Reads what was typed or pasted. A number may carry a unit and is converted to `unit`, the column's.
/// An empty text is an empty cell. Errors say what is wrong in words.
Result<SetupCell> parse_cell(const ColumnSpec& column, const Unit& unit, const QString& text,
                             const QLocale& locale);

/// The value of a row's cell under `key`; null: it has none, or something else than a `T`.
template <class T>
const T* cell_in(const FieldSpec& table, const std::vector<SetupCell>& row, const std::string& key) {
    const std::size_t column = SetupSchema::column(table, key);
    return column < row.size() ? std::get_if<T>(&row[column]) : nullptr;
}

/// Cell of a new row: the first choice, an unset flag, otherwise nothing.
SetupCell empty_cell(const ColumnSpec& column);

/// The field's table, each row with all columns, each column with its unit; empty where nothing is given.
SetupTable table_of(const FieldSpec& field, const Setup& setup);
/// The units of the field's columns as the schema has them.
std::vector<Unit> default_units(const FieldSpec& field);

/// Why `value` (SI) is outside of the range, in words and in `unit`; empty when it is inside.
QString range_complaint(const Range& range, double value, const Unit& unit, const QLocale& locale);

}  // namespace covaria::ui
