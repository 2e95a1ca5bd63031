// JSON to Setup, field by field as the schema says.
#include <array>

#include "core/project/csv_table.h"
#include "core/project/json_location.h"
#include "core/project/setup_json.h"
#include "core/project/table_columns.h"
#include "core/quantity/distribution.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

/// A field that is being read.
class ReadField {
public:
    ReadField(const FieldSpec& field, std::string path, ReadContext& context)
        : field_(field), path_(std::move(path)), context_(context) {}

protected:
    SetupValue refuse(const std::string& message, const std::string& below = {}) {
        context_.problems.error(path_ + below, message);
        return {};
    }
    std::string title() const { return "'" + field_.title + "'"; }

    const FieldSpec& field_;
    std::string path_;
    ReadContext& context_;
};

class TableReader : ReadField {
public:
    using ReadField::ReadField;

    SetupValue read(const Json& value) {
        ObjectReader reader(value, path_, title(), context_.problems);
        if (!value.is_object()) return {};
        if (reader.has("csv")) {
            const std::string file = reader.text("csv");
            const Json* columns = reader.find("columns");
            reader.refuse_unknown_keys();
            CsvColumns renamed;
            if (columns && !read_csv_columns(*columns, renamed)) return {};
            return csv_table(file, std::move(renamed));
        }
        const Json* columns = reader.list("columns");
        const Json* rows = reader.list("rows");
        reader.refuse_unknown_keys();
        if (!reader.has("columns") || !reader.has("rows"))
            return refuse(title() +
                          " is a table: it needs \"columns\" and \"rows\", or the name of a \"csv\" file");
        return columns && rows ? inline_table(*columns, *rows) : SetupValue{};
    }

private:
    SetupValue inline_table(const Json& columns, const Json& rows) {
        std::vector<std::string> headers;
        for (const Json& column : columns) {
            if (!column.is_string())
                return refuse("the columns of " + title() + " must be texts in quotes", "/columns");
            headers.push_back(column.get<std::string>());
        }
        Problems found;
        const auto matched = match_columns(field_, headers, found);
        context_.problems.take(found, path_);
        if (!matched) return {};
        SetupTable table;
        table.units = matched->units;
        table.rows.reserve(rows.size());
        for (std::size_t row = 0; row < rows.size(); ++row)
            table.rows.push_back(read_row(rows[row], row, *matched));
        return table;
    }

    std::vector<SetupCell> read_row(const Json& row, std::size_t index, const TableColumns& columns) {
        const std::string place = "/rows/" + std::to_string(index);
        std::vector<SetupCell> cells(field_.columns.size());
        const std::string name = "row " + std::to_string(index + 1) + " of " + title();
        if (!row.is_array() || row.size() != columns.target.size()) {
            refuse(name + (row.is_array() ? " has " + std::to_string(row.size()) + " cells; there are " +
                                                std::to_string(columns.target.size()) + " columns"
                                          : " must be a list in brackets, not " + json_words(row)),
                   place);
            return cells;
        }
        for (std::size_t i = 0; i < row.size(); ++i) {
            const ColumnSpec& column = field_.columns[columns.target[i]];
            if (auto cell = read_cell(row[i], column.kind))
                cells[columns.target[i]] = *cell;
            else
                refuse("'" + column.key + "' in " + name + " must be " + cell_words(column.kind) + ", not " +
                           json_words(row[i]),
                       place + "/" + column.key);
        }
        return cells;
    }

    static std::optional<SetupCell> read_cell(const Json& value, FieldKind kind) {
        if (value.is_null()) return SetupCell{};
        if (kind == FieldKind::number || kind == FieldKind::integer)
            return value.is_number() ? std::optional<SetupCell>(value.get<double>()) : std::nullopt;
        if (kind == FieldKind::flag)
            return value.is_boolean() ? std::optional<SetupCell>(value.get<bool>()) : std::nullopt;
        return value.is_string() ? std::optional<SetupCell>(value.get<std::string>()) : std::nullopt;
    }

    static std::string cell_words(FieldKind kind) {
        if (kind == FieldKind::number || kind == FieldKind::integer) return "a number";
        return kind == FieldKind::flag ? "true or false" : "a text in quotes";
    }

    bool read_csv_columns(const Json& columns, CsvColumns& renamed) {
        if (!columns.is_object()) {
            refuse("the columns of the CSV file of " + title() +
                       " must be an object in braces: a header of the file and the column it stands for",
                   "/columns");
            return false;
        }
        for (const auto& [header, column] : columns.items()) {
            if (!column.is_string()) {
                refuse("'" + header + "' must stand for a column of " + title() +
                           " (a text), or for none (an empty text)",
                       "/columns/" + header);
                return false;
            }
            renamed.emplace_back(header, column.get<std::string>());
        }
        return true;
    }

    SetupValue csv_table(const std::string& name, CsvColumns renamed) {
        const fs::path relative = fs::path(name).lexically_normal();
        if (name.empty() || relative.is_absolute() || *relative.begin() == "..")
            return refuse("the CSV file '" + name + "' of " + title() +
                              " must be named relative to the project's folder and lie in it",
                          "/csv");
        const fs::path file = context_.directory / relative;
        std::error_code ignored;
        if (!fs::exists(file, ignored))
            return refuse(
                "the CSV file of " + title() + " does not exist: looked for '" + file.string() + "'", "/csv");
        CsvTable read = table_from_csv_file(file, field_, renamed);
        for (Problem& problem : read.problems.items()) {
            problem.path = path_;
            problem.message = "CSV file of " + title() + ": " + problem.message;
            context_.problems.add(problem);
        }
        context_.csv.push_back({path_, file.string(), std::move(read.lines)});
        read.table.csv_file = name;
        read.table.csv_columns = std::move(renamed);
        return read.problems.has_errors() ? SetupValue{} : SetupValue(std::move(read.table));
    }
};

class FieldReader : ReadField {
public:
    using ReadField::ReadField;

    SetupValue read(const Json& value) {
        switch (field_.kind) {
            case FieldKind::number:
            case FieldKind::integer:
                return number(value);
            case FieldKind::choice:
            case FieldKind::text:
            case FieldKind::reference:
                return text(value);
            case FieldKind::flag:
                return flag(value);
            case FieldKind::pose:
                return pose(value);
            case FieldKind::table:
                return TableReader(field_, path_, context_).read(value);
        }
        return {};
    }

private:
    SetupValue number(const Json& value) {
        if (field_.unit.dimension().is_one() && value.is_number())
            return Quantity{value.get<double>(), Unit{}};
        if (field_.unit.dimension().is_one() && value.is_null()) return Quantity{infinity, Unit{}};
        if (field_.kind == FieldKind::integer)
            return refuse(title() + " must be a whole number, not " + json_words(value));
        if (value.is_number())
            return refuse(title() + " is " + dimension_words(field_.unit) +
                          "; its unit is missing: write {\"value\": " + shortest_number(value.get<double>()) +
                          ", \"unit\": \"" + field_.unit.text() + "\"}");
        if (!value.is_object()) return refuse(title() + " must be a number, not " + json_words(value));
        const auto quantity = quantity_from(value, path_, context_.problems);
        return quantity ? SetupValue(*quantity) : SetupValue{};
    }

    SetupValue text(const Json& value) {
        if (field_.several_lines && value.is_array()) return lines(value);
        if (!value.is_string())
            return refuse(title() + " must be a text in quotes, not " + json_words(value));
        return value.get<std::string>();
    }

    SetupValue lines(const Json& list) {
        std::string text;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (!list[i].is_string() || list[i].get<std::string>().find('\n') != std::string::npos)
                return refuse("the lines of " + title() + " must be texts in quotes, each one line",
                              "/" + std::to_string(i));
            text += (i == 0 ? "" : "\n") + list[i].get<std::string>();
        }
        return text;
    }

    SetupValue flag(const Json& value) {
        if (!value.is_boolean()) return refuse(title() + " must be true or false, not " + json_words(value));
        return value.get<bool>();
    }

    SetupValue pose(const Json& value) {
        ObjectReader reader(value, path_, title(), context_.problems);
        PoseValue pose;
        triple(reader, "position", pose.position);
        pose.length_unit = unit(reader, "lengthUnit");
        triple(reader, "angles", pose.angles);
        pose.angle_unit = unit(reader, "angleUnit");
        reader.refuse_unknown_keys();
        return pose;
    }

    void triple(ObjectReader& reader, const std::string& key, std::array<double, 3>& numbers) {
        const Json* list = reader.find(key);
        bool right = list && list->is_array() && list->size() == 3;
        for (std::size_t i = 0; right && i < 3; ++i) {
            right = (*list)[i].is_number();
            if (right) numbers[i] = (*list)[i].get<double>();
        }
        if (!right)
            refuse("'" + key + "' of " + title() + " must be a list of three numbers", list ? "/" + key : "");
    }

    Unit unit(ObjectReader& reader, const std::string& key) {
        const std::string text = reader.text(key, true);
        return text.empty() ? Unit{} : unit_from(text, reader.path_of(key), context_.problems);
    }
};

}  // namespace

Setup setup_from_json(const Json& value, const SetupSchema& schema, const std::string& path,
                      ReadContext& context) {
    Setup setup;
    ObjectReader reader(value, path, "this set-up", context.problems);
    for (const FieldSpec& field : schema.fields()) {
        const Json* found = reader.find(field.key);
        if (!found) continue;
        SetupValue read = FieldReader(field, reader.path_of(field.key), context).read(*found);
        if (!std::holds_alternative<std::monostate>(read)) setup.values[field.key] = std::move(read);
    }
    reader.refuse_unknown_keys();
    return setup;
}

}  // namespace covaria
