// Setup to canonical JSON: the schema's order of fields and columns; fields that were not given are not
// written.
#include <algorithm>

#include "core/project/setup_json.h"
#include "core/project/table_columns.h"
#include "core/quantity/distribution.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

// A column may be left out if reading the file then gives the same table back.
bool is_left_out(const SetupTable& table, const ColumnSpec& column, std::size_t index) {
    if (!column.optional || table.units[index] != column.unit) return false;
    return std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
        return index >= row.size() || std::holds_alternative<std::monostate>(row[index]);
    });
}

void write_cell(JsonWriter& out, const SetupCell& cell) {
    if (const double* number = std::get_if<double>(&cell)) {
        out.finite_number(*number);
    } else if (const std::string* text = std::get_if<std::string>(&cell)) {
        out.text(*text);
    } else if (const bool* flag = std::get_if<bool>(&cell)) {
        out.boolean(*flag);
    } else {
        out.null();
    }
}

void write_rows(JsonWriter& out, const SetupTable& table, const std::vector<std::size_t>& columns) {
    out.begin_list();
    for (const auto& row : table.rows) {
        out.begin_list(Style::one_line);
        for (const std::size_t column : columns)
            write_cell(out, column < row.size() ? row[column] : SetupCell{});
        out.end();
    }
    out.end();
}

void write_table(JsonWriter& out, const SetupTable& table, const FieldSpec& field) {
    if (!table.csv_file.empty()) {
        out.begin_object(Style::one_line);
        out.key("csv");
        out.text(table.csv_file);
        if (!table.csv_columns.empty()) {
            out.key("columns");
            out.begin_object(Style::one_line);
            for (const auto& [header, column] : table.csv_columns) {
                out.key(header);
                out.text(column);
            }
            out.end();
        }
        out.end();
        return;
    }
    SetupTable with_units{table.units, table.rows, {}, {}};
    for (std::size_t i = table.units.size(); i < field.columns.size(); ++i)
        with_units.units.push_back(field.columns[i].unit);
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < field.columns.size(); ++i)
        if (!is_left_out(with_units, field.columns[i], i)) columns.push_back(i);
    out.begin_object();
    out.key("columns");
    out.begin_list(Style::one_line);
    for (const std::size_t i : columns) out.text(column_header(field.columns[i], with_units.units[i]));
    out.end();
    out.key("rows");
    write_rows(out, with_units, columns);
    out.end();
}

void write_triple(JsonWriter& out, const char* key, const std::array<double, 3>& numbers) {
    out.key(key);
    out.begin_list();
    for (const double number : numbers) out.finite_number(number);
    out.end();
}

void write_pose(JsonWriter& out, const PoseValue& pose) {
    out.begin_object(Style::one_line);
    write_triple(out, "position", pose.position);
    out.key("lengthUnit");
    out.text(pose.length_unit.text());
    write_triple(out, "angles", pose.angles);
    out.key("angleUnit");
    out.text(pose.angle_unit.text());
    out.end();
}

void write_lines(JsonWriter& out, const std::string& text) {
    out.begin_list();
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        out.text(text.substr(begin, end - begin));
        begin = end + 1;
    }
    out.end();
}

void write_value(JsonWriter& out, const SetupValue& value, const FieldSpec& field) {
    if (const Quantity* quantity = std::get_if<Quantity>(&value)) {
        if (quantity->unit == Unit{} && field.unit.dimension().is_one())
            out.number(quantity->value);
        else
            write_quantity(out, *quantity);
    } else if (const bool* flag = std::get_if<bool>(&value)) {
        out.boolean(*flag);
    } else if (const std::string* text = std::get_if<std::string>(&value)) {
        if (field.several_lines)
            write_lines(out, *text);
        else
            out.text(*text);
    } else if (const SetupTable* table = std::get_if<SetupTable>(&value)) {
        write_table(out, *table, field);
    } else if (const PoseValue* pose = std::get_if<PoseValue>(&value)) {
        write_pose(out, *pose);
    }
}

}  // namespace

void write_quantity(JsonWriter& out, const Quantity& quantity) {
    if (quantity.value == -infinity) out.note_unwritable();
    out.begin_object(Style::one_line);
    out.key("value");
    out.number(quantity.value);
    out.key("unit");
    out.text(quantity.unit.text());
    out.end();
}

void write_setup(JsonWriter& out, const Setup& setup, const SetupSchema& schema) {
    out.begin_object();
    for (const FieldSpec& field : schema.fields()) {
        const auto given = setup.values.find(field.key);
        if (given == setup.values.end() || std::holds_alternative<std::monostate>(given->second)) continue;
        out.key(field.key);
        write_value(out, given->second, field);
    }
    out.end();
    for (const auto& [key, value] : setup.values)
        if (!schema.find(key)) out.note_unwritable();
}

}  // namespace covaria
