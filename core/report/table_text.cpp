// Cells and heads of a report's tables as text; shared by all writers so that they agree.
#include "core/report/table_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/text/written_out.h"

namespace covaria {
namespace {

/// Of a number that is shown in its own unit, or in that of its column.
const Unit& unit_of(const TableCell& cell, const TableColumn& column) {
    const auto* quantity = std::get_if<Quantity>(&cell);
    return quantity ? quantity->unit : column.unit;
}

/// Of the numbers of a row that are in the unit of this one; nothing where it shares no power of ten.
std::optional<double> largest_of_row(const TableBlock& block, const ColumnStyle& style, std::size_t row,
                                     std::size_t column) {
    if (style.row.empty()) return std::nullopt;
    const auto& cells = block.table.rows[row];
    double largest = 0.0;
    for (const int other : style.row) {
        const auto at = static_cast<std::size_t>(other);
        if (at >= cells.size()) continue;
        const TableColumn& head = block.table.columns[at];
        const auto number = shown_number(cells[at], head);
        if (number && std::isfinite(*number) &&
            unit_of(cells[at], head) == unit_of(cells[column], block.table.columns[column]))
            largest = std::max(largest, std::abs(*number));
    }
    return largest;
}

/// Of all numbers of a column in the unit of this one, which are read against each other.
NumberForm form_of(const TableBlock& block, std::size_t row, std::size_t column) {
    constexpr std::size_t most_rows = 1000;  // of a longer table nobody sees the whole
    if (block.table.rows.size() > most_rows) return NumberForm::each;
    const TableColumn& head = block.table.columns[column];
    const Unit& unit = unit_of(block.table.rows[row][column], head);
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (const auto& cells : block.table.rows) {
        const auto number = column < cells.size() ? shown_number(cells[column], head) : std::nullopt;
        const double size = std::abs(number.value_or(0.0));
        if (!(size > 0.0) || !std::isfinite(size) || !(unit_of(cells[column], head) == unit)) continue;
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    return largest > 0.0 ? form_of_column(smallest, largest) : NumberForm::each;
}

std::string matched(double number, double uncertainty, int digits, std::optional<double> largest) {
    if (!largest || !std::isfinite(uncertainty) || uncertainty == 0.0)
        return format_to_match(number, uncertainty, digits);
    return format_in_row(number, decimals_for(uncertainty, digits), *largest);
}

/// That of all its numbers, where each has it by itself; nothing for numbers in the unit of the head.
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

/// Of a column of one kind of quantity, to which nothing else gives them; -1: of each number by itself.
/// Deviations, which have signs, are read against the largest one, and so are numbers that were computed;
/// uncertainties have digits of their own.
int decimals_of_column(const DataTable& table, std::size_t column) {
    const TableColumn& head = table.columns[column];
    if (head.unit == Unit{} || head.decimals >= 0 || head.match >= 0) return -1;
    std::vector<double> numbers;
    double smallest = 0.0, largest = 0.0;
    for (const auto& cells : table.rows) {
        const auto number = column < cells.size() ? shown_number(cells[column], head) : std::nullopt;
        if (!number) continue;
        if (!(unit_of(cells[column], head) == head.unit) || !std::isfinite(*number)) return -1;
        numbers.push_back(without_residue(*number, head.unit));
        smallest = std::min(smallest, numbers.back());
        largest = std::max(largest, std::abs(numbers.back()));
    }
    const bool are_deviations = head.digits > 0 && smallest < 0.0;
    if (numbers.empty() || (head.digits > 0 && !are_deviations)) return -1;
    int decimals = are_deviations ? -1 : common_decimals(numbers);
    if (decimals < 0 && largest > 0.0) {
        decimals = std::max(0, decimals_for(largest, are_deviations ? head.digits : computed_digits));
        // 21.521 degC is computed, too: in K it is another number.
        const auto has_no_more = [&](int fewer) {
            return std::ranges::all_of(numbers, [fewer, step = std::pow(10.0, -decimals)](double number) {
                const double part = number * std::pow(10.0, fewer);
                return std::abs(part - std::round(part)) < 0.5 * step * std::pow(10.0, fewer);
            });
        };
        while (!are_deviations && decimals > 0 && has_no_more(decimals - 1)) --decimals;
    }
    const bool is_lost = std::ranges::any_of(numbers, [step = std::pow(10.0, -decimals)](double number) {
        return number != 0.0 && std::abs(number) < 0.5 * step;
    });
    return decimals <= most_shared_decimals && !is_lost ? decimals : -1;
}

}  // namespace

TableBlock read_table(DataTable table, const NumberLocale& locale) {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (const auto unit = unit_of_cells(table, c); unit && table.columns[c].unit == Unit{})
            table.columns[c].unit = *unit;
    TableBlock block{std::move(table), {}, locale};
    block.styles.resize(block.table.columns.size());
    for (std::size_t c = 0; c < block.styles.size(); ++c)
        block.styles[c].decimals = decimals_of_column(block.table, c);
    return block;
}

ColumnStyle style_of(const TableBlock& block, std::size_t column) {
    return column < block.styles.size() ? block.styles[column] : ColumnStyle{};
}

bool is_subhead(const TableBlock& block, std::size_t row) {
    const auto& cells = block.table.rows[row];
    return cells.size() == 1 && block.table.columns.size() > 1 &&
           std::holds_alternative<std::string>(cells.front());
}

std::optional<double> shown_number(const TableCell& cell, const TableColumn& column) {
    if (const auto* value = std::get_if<double>(&cell)) return column.unit.from_si(*value);
    if (const auto* quantity = std::get_if<Quantity>(&cell)) return quantity->value;
    return std::nullopt;
}

std::string cell_text(const TableBlock& block, std::size_t row, std::size_t column) {
    const auto& cells = block.table.rows[row];
    if (column >= cells.size()) return {};
    const TableCell& cell = cells[column];
    const TableColumn& head = block.table.columns[column];
    const auto number = shown_number(cell, head);
    const ColumnStyle style = style_of(block, column);
    if (!number) return format_cell(cell, head);
    if (style.decimals >= 0) return format_decimals(*number, style.decimals);
    if (row < style.by_row.size() && style.by_row[row] >= 0)
        return format_decimals(*number, style.by_row[row]);
    const std::optional<double> largest = largest_of_row(block, style, row, column);
    if (style.match >= 0) {
        const auto other = static_cast<std::size_t>(style.match);
        if (const auto u = shown_number(cells[other], block.table.columns[other]))
            return style.input ? format_estimate(*number, *u)
                               : matched(*number, *u, head.digits > 0 ? head.digits : 2, largest);
    }
    if (style.by_spread && row < block.spreads.size()) {
        const auto* quantity = std::get_if<Quantity>(&cell);
        const double spread = block.spreads[row];
        return matched(*number, quantity ? quantity->unit.interval_from_si(spread) : spread,
                       head.digits > 0 ? head.digits : 2, largest);
    }
    if (head.match >= 0) {
        const auto other = static_cast<std::size_t>(head.match);
        const auto u =
            other < cells.size() ? shown_number(cells[other], block.table.columns[other]) : std::nullopt;
        const auto* own = std::get_if<Quantity>(&cell);
        if (u) return format_to_match(*number, *u) + (own ? unit_of_cell(*own, head) : std::string());
    }
    if (head.digits > 0 && head.decimals < 0) {
        const auto* quantity = std::get_if<Quantity>(&cell);
        const double shown = without_residue(*number, style.bare ? Unit{} : unit_of(cell, head));
        const bool in_row = largest && std::isfinite(shown) && shown != 0.0;
        return (in_row ? format_in_row(shown, decimals_for(shown, head.digits), *largest)
                       : format_significant(shown, head.digits, form_of(block, row, column))) +
               (quantity && !style.bare ? unit_of_cell(*quantity, head) : std::string());
    }
    if (style.bare) {
        TableColumn plain = head;
        plain.unit = Unit{};
        return format_cell(*number, plain);
    }
    return format_cell(cell, head);
}

bool is_numeric_column(const TableBlock& block, std::size_t column) {
    bool any = false;
    for (std::size_t r = 0; r < block.table.rows.size(); ++r) {
        if (is_subhead(block, r) || column >= block.table.rows[r].size()) continue;
        const TableCell& cell = block.table.rows[r][column];
        if (std::holds_alternative<std::monostate>(cell)) continue;
        // A number with a unit of its own is a text.
        if (std::holds_alternative<Message>(cell)) return false;
        if (std::holds_alternative<std::string>(cell) && style_of(block, column).match < 0) return false;
        any = true;
    }
    return any;
}

Text head_text(const TableColumn& column) {
    return head_with_unit(column.is_symbol ? symbols_text(column.header) : running_text(column.header),
                          column.unit);
}

Text cell_typeset(const TableBlock& block, std::size_t row, std::size_t column) {
    const std::string text = cell_text(block, row, column);
    if (style_of(block, column).symbol && !is_subhead(block, row)) return symbols_text(text);
    const auto& cells = block.table.rows[row];
    const bool number = column < cells.size() && shown_number(cells[column], block.table.columns[column]);
    return number ? Text(grouped_digits(text, block.locale)) : running_text(text);
}

}  // namespace covaria
