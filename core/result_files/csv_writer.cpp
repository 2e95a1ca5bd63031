// CSV (RFC 4180): full precision, units in the heads, or in a column of their own where rows differ.
#include "core/result_files/csv_writer.h"

#include "core/result_files/csv_text.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

/// A cell, and the unit of its number behind it where `with_unit`: a number alone has none.
std::string exact_cell(const Cell& cell, const DisplayUnits& units, bool with_unit) {
    const auto number = exact_quantity(cell, units);
    const std::string text = number ? format_exact(number->value) : csv_text(english_of(cell, units));
    if (!with_unit) return text;
    const bool is_alone = !number || (std::holds_alternative<Measured>(cell) && number->unit == Unit{});
    return text + "," + (is_alone ? "" : csv_text(number->unit.text()));
}

Unit unit_of_head(const Column& column, const DisplayUnits& units) {
    return column.unit ? units.of(*column.unit) : Unit{};
}

/// Whether numbers of the column have units that the head does not give.
bool needs_units(const Table& table, const Column& column, const DisplayUnits& units) {
    const Unit of_head = unit_of_head(column, units);
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto number = exact_quantity(column.cell(row), units);
        if (number && !(number->unit == of_head)) return true;
    }
    return false;
}

}  // namespace

std::string to_csv(const Table& table, const DisplayUnits& units) {
    struct Written {
        const Column* column;
        bool with_units;
    };
    const Column* of_units = table.find("unit");
    const bool rows_say_units = of_units && of_units->in_files;
    std::vector<Written> columns;
    std::string out;
    for (const Column& column : table.columns) {
        if (!column.in_files) continue;
        const bool with_units = !rows_say_units && needs_units(table, column, units);
        const std::string unit = with_units ? "" : unit_of_head(column, units).text();
        out += (columns.empty() ? "" : ",") + csv_text(csv_head(column.key, unit));
        if (with_units) out += "," + csv_text(column.key + " unit");
        columns.push_back({&column, with_units});
    }
    out += "\r\n";
    for (std::size_t row = 0; row < table.rows; ++row) {
        for (std::size_t c = 0; c < columns.size(); ++c)
            out += (c ? "," : "") + exact_cell(columns[c].column->cell(row), units, columns[c].with_units);
        out += "\r\n";
    }
    return out;
}

}  // namespace covaria
