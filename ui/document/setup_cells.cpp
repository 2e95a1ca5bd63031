// One place for the text of cells: tables, pasting and import agree.
#include "ui/document/setup_cells.h"

#include <cmath>

#include "core/base/temperature.h"
#include "ui/document/quantity_text.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

tl::unexpected<Error> refuse(const QString& message) {
    return fail(ErrorCode::bad_input, to_std(message));
}

Result<SetupCell> parse_number_cell(const ColumnSpec& column, const Unit& unit, const QString& text,
                                    const QLocale& locale) {
    const auto quantity = parse_quantity(text, unit, locale);
    if (!quantity) return fail(quantity.error());
    if (is_reading_for_difference((**quantity).unit, column.unit))
        return fail(ErrorCode::bad_input, reading_objection((**quantity).unit, column.unit));
    const double value = converted((**quantity).value, (**quantity).unit, unit);
    if (column.kind == FieldKind::integer && value != std::round(value))
        return refuse(tr("“%1” is not a whole number.").arg(text.trimmed()));
    if (const QString complaint = range_complaint(column.range, unit.to_si(value), unit, locale);
        !complaint.isEmpty())
        return refuse(complaint);
    return SetupCell(value);
}

Result<SetupCell> parse_choice_cell(const ColumnSpec& column, const QString& text) {
    const QStringList titles = choice_words(column);
    for (std::size_t i = 0; i < column.choices.size(); ++i) {
        const Choice& choice = column.choices[i];
        for (const QString& name : {to_qt(choice.key), to_qt(choice.title), titles[qsizetype(i)]})
            if (text.compare(name, Qt::CaseInsensitive) == 0) return SetupCell(choice.key);
    }
    return refuse(tr("“%1” is not one of: %2.").arg(text, titles.join(", ")));
}

Result<SetupCell> parse_flag_cell(const QString& text) {
    const QString lower = text.toLower();
    if (QStringList{"true", "yes", "1", tr("yes")}.contains(lower)) return SetupCell(true);
    if (QStringList{"false", "no", "0", tr("no")}.contains(lower)) return SetupCell(false);
    return refuse(tr("“%1” is neither yes nor no.").arg(text));
}

}  // namespace

QStringList choice_words(const ColumnSpec& column) {
    QStringList words;
    for (const Choice& choice : column.choices)
        words << (column.capabilities.empty() ? core_text(choice.title) : to_qt(choice.title));
    return words;
}

QString cell_text(const ColumnSpec& column, const SetupCell& cell, const QLocale& locale) {
    if (const double* number = std::get_if<double>(&cell)) return number_text(*number, locale);
    if (const bool* flag = std::get_if<bool>(&cell)) return *flag ? tr("yes") : tr("no");
    const std::string* text = std::get_if<std::string>(&cell);
    if (!text) return {};
    for (std::size_t i = 0; i < column.choices.size(); ++i)
        if (column.choices[i].key == *text) return choice_words(column)[qsizetype(i)];
    return to_qt(*text);
}

Result<SetupCell> parse_cell(const ColumnSpec& column, const Unit& unit, const QString& text,
                             const QLocale& locale) {
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty()) return SetupCell{};
    switch (column.kind) {
        case FieldKind::number:
        case FieldKind::integer:
            return parse_number_cell(column, unit, trimmed, locale);
        case FieldKind::choice:
            return parse_choice_cell(column, trimmed);
        case FieldKind::flag:
            return parse_flag_cell(trimmed);
        default:
            return SetupCell(to_std(trimmed));
    }
}

SetupCell empty_cell(const ColumnSpec& column) {
    if (column.optional) return {};
    if (column.kind == FieldKind::choice && !column.choices.empty()) return column.choices.front().key;
    if (column.kind == FieldKind::flag) return false;
    return {};
}

std::vector<Unit> default_units(const FieldSpec& field) {
    std::vector<Unit> units;
    for (const ColumnSpec& column : field.columns) units.push_back(column.unit);
    return units;
}

SetupTable table_of(const FieldSpec& field, const Setup& setup) {
    SetupTable table;
    if (const auto* given = std::get_if<SetupTable>(&value_of(field, setup))) table = *given;
    const std::vector<Unit> units = default_units(field);
    for (std::size_t i = table.units.size(); i < units.size(); ++i) table.units.push_back(units[i]);
    for (auto& row : table.rows) row.resize(field.columns.size());
    return table;
}

QString range_complaint(const Range& range, double value, const Unit& unit, const QLocale& locale) {
    const auto limit = [&](double si) {
        return quantity_text({QString::number(unit.from_si(si), 'g', 12).toDouble(), unit}, locale);
    };
    if (range.low_open && !(value > range.low))
        return tr("The value must be greater than %1.").arg(limit(range.low));
    if (!(value >= range.low)) return tr("The value must be at least %1.").arg(limit(range.low));
    if (!(value <= range.high)) return tr("The value must be at most %1.").arg(limit(range.high));
    return {};
}

}  // namespace covaria::ui
