// CSV (RFC 4180): full precision, units in the heads, or in a column of their own where rows differ.
#include "core/result_files/csv_text.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

std::string exact_cell(const TableCell& cell, const TableColumn& column) {
    if (const auto* value = std::get_if<double>(&cell)) return format_exact(column.unit.from_si(*value));
    if (const auto* quantity = std::get_if<Quantity>(&cell)) return format_exact(quantity->value);
    return csv_text(english_of(cell));
}

bool has_unit_column(const DataTable& table) {
    for (const TableColumn& column : table.columns)
        if (column.header == "unit") return true;
    return false;
}

/// Whether quantities of the column have units that neither the head nor a "unit" column gives.
bool needs_units(const DataTable& table, std::size_t column) {
    if (has_unit_column(table)) return false;
    for (const auto& row : table.rows) {
        if (column >= row.size()) continue;
        const auto* quantity = std::get_if<Quantity>(&row[column]);
        if (quantity && !(quantity->unit == table.columns[column].unit)) return true;
    }
    return false;
}

std::string unit_cell(const std::vector<TableCell>& row, std::size_t column) {
    if (column >= row.size()) return {};
    const auto* quantity = std::get_if<Quantity>(&row[column]);
    return quantity ? csv_text(quantity->unit.text()) : "";
}

std::string head_line(const DataTable& table, const std::vector<bool>& with_units) {
    std::string line;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const TableColumn& column = table.columns[c];
        const std::string unit = with_units[c] ? "" : column.unit.text();
        line += (c ? "," : "") + csv_text(csv_head(column.header, unit));
        if (with_units[c]) line += "," + csv_text(column.header + " unit");
    }
    return line + "\r\n";
}

}  // namespace

std::string to_csv(const DataTable& table) {
    std::vector<bool> with_units;
    for (std::size_t c = 0; c < table.columns.size(); ++c) with_units.push_back(needs_units(table, c));
    std::string out = head_line(table, with_units);
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            out += (c ? "," : "") + (c < row.size() ? exact_cell(row[c], table.columns[c]) : "");
            if (with_units[c]) out += "," + unit_cell(row, c);
        }
        out += "\r\n";
    }
    return out;
}

}  // namespace covaria
