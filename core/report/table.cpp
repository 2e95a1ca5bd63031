// Cells of a table as the views show them.
#include "core/report/table.h"
#include "core/text/head_with_unit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace covaria {
namespace {

std::string joined(const Symbols& symbols) {
    std::string text;
    for (const std::string& symbol : symbols) text += (text.empty() ? "" : ", ") + symbol;
    return text;
}

TableCell file_cell(const Cell& cell, const DisplayUnits& units) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* message = std::get_if<Message>(&cell)) return message->english();
    if (const auto* text = std::get_if<Text>(&cell)) return to_unicode(*text);
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return joined(*symbols);
    if (const auto* unit = std::get_if<Unit>(&cell)) return units.of(*unit).text();
    if (const auto* answer = std::get_if<Answer>(&cell)) return answer->is ? answer->yes : answer->no;
    if (const auto* number = std::get_if<Measured>(&cell)) return number->in(units);
    return {};
}

double as_headed(const NumberRule& rule, double value) {
    return rule.percent ? 100.0 * value : value;
}

}  // namespace

Unit quotient(const Unit& of, const Unit& per) {
    if (per == Unit{}) return of;
    const Unit of_differences = of.interval(), per_one = per.interval();
    if (of_differences == per_one) return {};
    return Unit::parse(of_differences.text() + "/(" + per_one.text() + ")").value_or(of_differences);
}

Quantity Measured::in(const DisplayUnits& units) const {
    const Unit& shown = units.of(unit);
    if (scale == Scale::value) return {shown.from_si(si), shown};
    const Unit& of_one = units.of(per);
    return {shown.interval_from_si(si * of_one.interval_to_si(1.0)), quotient(shown, of_one)};
}

const Column* Table::find(std::string_view key) const {
    const auto it = std::ranges::find(columns, key, &Column::key);
    return it == columns.end() ? nullptr : &*it;
}

const Column& Table::operator[](std::string_view key) const {
    const Column* found = find(key);
    if (!found) throw std::out_of_range("no column " + std::string(key) + " in table " + id);
    return *found;
}

DataTable data_table(const Table& table, const std::vector<std::string>& keys, const DisplayUnits& units) {
    DataTable data{table.id, table.title, {}, {}, {}};
    std::vector<const Column*> chosen;
    for (const std::string& key : keys) chosen.push_back(&table[key]);
    for (const Column* column : chosen)
        data.columns.push_back({column->key, column->unit ? units.of(*column->unit) : Unit{}, false, 0});
    for (std::size_t row = 0; row < table.rows; ++row) {
        data.rows.emplace_back();
        for (const Column* column : chosen) data.rows.back().push_back(file_cell(column->cell(row), units));
    }
    return data;
}

DataTable data_table(const Table& table) {
    std::vector<std::string> keys;
    for (const Column& column : table.columns)
        if (column.in_files) keys.push_back(column.key);
    return data_table(table, keys);
}

std::optional<double> number_in(const Cell& cell, const DisplayUnits& units) {
    const auto* number = std::get_if<Measured>(&cell);
    return number ? std::optional(number->in(units).value) : std::nullopt;
}

std::optional<double> exact_number(const Column& column, std::size_t row, const DisplayUnits& units) {
    std::optional<double> number = number_in(column.cell(row), units);
    if (number) *number = as_headed(column.rule, *number);
    return number;
}

bool is_numeric(const Column& column) {
    const NumberRule& rule = column.rule;
    return rule.digits > 0 || rule.decimals >= 0 || !rule.match.empty() || rule.typed ||
           rule.degrees_of_freedom;
}

std::optional<double> matched_to(const Table& table, const Column& column, std::size_t row,
                                 const DisplayUnits& units) {
    return column.rule.match.empty() ? std::nullopt : number_in(table.cell(row, column.rule.match), units);
}

namespace {

/// Of the numbers of a row that are in the unit of this one; nothing where its column shares no power of ten.
std::optional<double> largest_of_row(const Table& table, const Column& column, std::size_t row,
                                     const DisplayUnits& units) {
    if (column.rule.row.empty()) return std::nullopt;
    const Unit unit = std::get<Measured>(column.cell(row)).in(units).unit;
    double largest = 0.0;
    for (const std::string& key : column.rule.row) {
        const Column* other = table.find(key);
        if (!other) continue;
        const Cell cell = other->cell(row);
        const auto* number = std::get_if<Measured>(&cell);
        const Quantity shown = number ? number->in(units) : Quantity{};
        if (number && shown.unit == unit && std::isfinite(shown.value))
            largest = std::max(largest, std::abs(shown.value));
    }
    return largest;
}

/// Of a column whose head has the unit of all its numbers.
NumberForm form_of(const Table& table, const Column& column, const DisplayUnits& units) {
    if (!column.unit || column.rule.digits == 0 || !column.rule.match.empty()) return NumberForm::each;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double size = std::abs(number_in(column.cell(row), units).value_or(0.0));
        if (!(size > 0.0) || !std::isfinite(size)) continue;
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    return largest > 0.0 ? form_of_column(smallest, largest) : NumberForm::each;
}

}  // namespace

std::string format_by(const NumberRule& rule, double value, const NumberPlace& place) {
    const std::optional<double>& other = place.other;
    if (rule.degrees_of_freedom) return format_degrees_of_freedom(value);
    value = as_headed(rule, value);
    if (rule.of_limit) return format_part_of_limit(value, rule.decimals);
    if (rule.decimals >= 0) return format_decimals(value, rule.decimals);
    const bool matches = other && !rule.input && std::isfinite(*other) && *other != 0.0;
    if (place.largest && matches)
        return format_in_row(value, decimals_for(*other, rule.digits > 0 ? rule.digits : 2), *place.largest);
    if (place.largest && !other && rule.digits > 0 && std::isfinite(value) && value != 0.0)
        return format_in_row(value, decimals_for(value, rule.digits), *place.largest);
    if (other) {
        return rule.input ? format_estimate(value, *other)
                          : format_to_match(value, *other, rule.digits > 0 ? rule.digits : 2);
    }
    return rule.digits > 0 ? format_significant(value, rule.digits, place.column) : format_typed(value);
}

Text head_shown(const Column& column, const TableView& view) {
    return head_shown(column.title, column, view);
}

Text head_shown(const Text& title, const Column& column, const TableView& view) {
    return column.unit ? head_with_unit(title, view.units.of(*column.unit)) : title;
}

Text cell_shown(const Table& table, const Column& column, std::size_t row, const TableView& view) {
    const Cell cell = column.cell(row);
    if (auto number = number_in(cell, view.units)) {
        const Measured& measured = std::get<Measured>(cell);
        if (measured.per == Unit{}) number = without_residue(*number, measured.in(view.units).unit);
        NumberRule rule = column.rule;
        if (view.digits > 0 && !rule.typed)
            rule.digits = rule.no_fewer ? std::max(rule.digits, view.digits) : view.digits;
        const NumberPlace place{matched_to(table, column, row, view.units),
                                largest_of_row(table, column, row, view.units),
                                form_of(table, column, view.units)};
        return grouped_digits(format_by(rule, *number, place), view.language.numbers()) +
               (column.says_unit ? unit_after_number(measured.in(view.units).unit) : std::string());
    }
    if (const auto* unit = std::get_if<Unit>(&cell)) return view.units.of(*unit).display();
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return symbols_text(joined(*symbols));
    if (const auto* answer = std::get_if<Answer>(&cell))
        return answer->is_open ? view.language.say(tell<"undecided">())
                               : view.language.say_declared(answer->is ? "yes" : "no");
    if (const auto* message = std::get_if<Message>(&cell)) return running_text(view.language.say(*message));
    if (const auto* text = std::get_if<Text>(&cell)) return *text;
    const auto* words = std::get_if<std::string>(&cell);
    if (!words) return {};
    return column.own_words ? view.language.say_title(*words) : Text(*words);
}

}  // namespace covaria
