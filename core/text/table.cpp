#include "core/text/table.h"

#include <algorithm>
#include <stdexcept>

namespace covaria {
namespace {

std::string joined(const Symbols& symbols) {
    std::string text;
    for (const std::string& symbol : symbols) text += (text.empty() ? "" : ", ") + symbol;
    return text;
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

Cells Cells::part(std::size_t begin, std::size_t end) const {
    if (of_row_) return Cells([of_row = of_row_, begin](std::size_t row) { return of_row(begin + row); });
    Cells some;
    for (std::size_t row = begin; row < std::min(end, held_.size()); ++row) some.held_.push_back(held_[row]);
    return some;
}

void Table::row(std::vector<Cell> cells) {
    for (std::size_t c = 0; c < std::min(cells.size(), columns.size()); ++c) {
        const std::optional<Unit>& unit = columns[c].unit;
        if (auto* number = std::get_if<Measured>(&cells[c]);
            number && unit && number->unit == Unit{} && number->per == Unit{})
            *number = Measured(number->si, Measured::Scale::value, *unit);
        columns[c].cell.hold(rows, std::move(cells[c]));
    }
    ++rows;
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

std::size_t Table::shown_columns() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(columns, [](const Column& column) { return !column.hidden; }));
}

Table Table::part(std::size_t begin, std::size_t end) const {
    Table some{id, title, end - begin, columns, notes, {}};
    for (Column& column : some.columns) {
        column.cell = column.cell.part(begin, end);
        std::vector<int>& decimals = column.rule.by_row;
        decimals.erase(decimals.begin(),
                       decimals.begin() + static_cast<std::ptrdiff_t>(std::min(begin, decimals.size())));
    }
    for (const auto& [row, text] : subheads)
        if (row >= begin && row < end) some.subheads.emplace(row - begin, text);
    return some;
}

Table file_table(const Table& table) {
    Table held{table.id, table.title, table.rows, {}, table.notes, table.subheads};
    for (const Column& column : table.columns) {
        if (!column.in_files) continue;
        Cells cells;
        for (std::size_t row = 0; row < table.rows; ++row) cells.hold(row, column.cell(row));
        held.add(column).cell = std::move(cells);
    }
    return held;
}

std::string english_of(const Cell& cell, const DisplayUnits& units) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* message = std::get_if<Message>(&cell)) return message->english();
    if (const auto* text = std::get_if<Text>(&cell)) return to_unicode(*text);
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return joined(*symbols);
    if (const auto* unit = std::get_if<Unit>(&cell)) return units.of(*unit).text();
    if (const auto* answer = std::get_if<Answer>(&cell)) return answer->is ? answer->yes : answer->no;
    if (const auto* verdict = std::get_if<TestVerdict>(&cell)) return verdict->words.english();
    return {};
}

std::optional<Quantity> exact_quantity(const Cell& cell, const DisplayUnits& units) {
    if (const auto* number = std::get_if<Measured>(&cell)) return number->in(units);
    const auto* quantity = std::get_if<Quantity>(&cell);
    return quantity ? std::optional(*quantity) : std::nullopt;
}

}  // namespace covaria
