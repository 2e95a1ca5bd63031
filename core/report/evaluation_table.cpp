#include "core/report/evaluation_table.h"

#include <algorithm>
#include <cmath>

namespace covaria {
namespace {

/// That of all numbers of a column, where each has it by itself; nothing for numbers in the unit of the head.
std::optional<Unit> unit_of_cells(const DataTable& table, std::size_t column) {
    std::optional<Unit> unit;
    for (const auto& cells : table.rows) {
        if (column >= cells.size() || std::holds_alternative<std::monostate>(cells[column])) continue;
        const auto* quantity = std::get_if<Quantity>(&cells[column]);
        if (!quantity || (unit && !(quantity->unit == *unit))) return std::nullopt;
        unit = quantity->unit;
    }
    return unit;
}

/// A number smaller than this, in SI, is the rounding of a sum beside the largest of its column.
double rounding_of(const DataTable& table, std::size_t column) {
    constexpr double rounding = 1e-14;
    if (table.columns[column].unit == Unit{}) return 0.0;
    double largest = 0.0;
    for (const auto& cells : table.rows)
        if (const double* value = column < cells.size() ? std::get_if<double>(&cells[column]) : nullptr)
            largest = std::max(largest, std::abs(*value));
    return rounding * largest;
}

NumberRule rule_of(const TableColumn& column) {
    if (column.decimals >= 0) return {.role = NumberRole::fixed, .decimals = column.decimals};
    if (column.match >= 0) return {.role = NumberRole::estimate, .of = std::to_string(column.match)};
    if (column.digits > 0) return {.role = NumberRole::figure, .digits = column.digits};
    return {};
}

void add_column(const DataTable& made, std::size_t c, const DocumentLanguage& in, Table& table) {
    const TableColumn& from = made.columns[c];
    Column& column = table.add(std::to_string(c));
    column.title = from.is_symbol ? symbols_text(from.header) : running_text(in.say_declared(from.header));
    column.rule = rule_of(from);
    const std::optional<Unit> common = unit_of_cells(made, c);
    column.unit = common && from.unit == Unit{} ? *common : from.unit;
    column.says_unit = std::ranges::any_of(made.rows, [&](const std::vector<TableCell>& cells) {
        const auto* quantity = c < cells.size() ? std::get_if<Quantity>(&cells[c]) : nullptr;
        return quantity && !(quantity->unit == *column.unit);
    });
}

Cell cell_of(const TableCell& made, double rounding) {
    if (const auto* number = std::get_if<double>(&made))
        return Measured(std::abs(*number) < rounding ? 0.0 : *number);
    if (const auto* quantity = std::get_if<Quantity>(&made)) return *quantity;
    if (const auto* text = std::get_if<std::string>(&made)) return *text;
    if (const auto* words = std::get_if<Message>(&made)) return *words;
    return {};
}

}  // namespace

Table evaluation_table(const DataTable& made, const DocumentLanguage& in) {
    Table table{made.id, in.say_declared(made.title)};
    std::vector<double> rounding;
    for (std::size_t c = 0; c < made.columns.size(); ++c) {
        add_column(made, c, in, table);
        rounding.push_back(rounding_of(made, c));
    }
    for (const std::vector<TableCell>& cells : made.rows) {
        std::vector<Cell> row;
        for (std::size_t c = 0; c < std::min(cells.size(), made.columns.size()); ++c)
            row.push_back(cell_of(cells[c], rounding[c]));
        table.row(std::move(row));
    }
    for (const Message& note : made.notes) table.notes.push_back(in.say(note));
    share_decimals(table);
    return table;
}

TableBlock evaluation_block(const DataTable& made, const DocumentLanguage& in) {
    return {evaluation_table(made, in), {{}, 2, in}};
}

}  // namespace covaria
