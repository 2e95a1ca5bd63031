// JSON to Setup, field by field as the schema says.
#include <array>

#include "core/base/in_quotes.h"
#include "core/base/own_folder.h"
#include "core/project/csv_table.h"
#include "core/project/json_location.h"
#include "core/project/setup_json.h"
#include "core/project/table_columns.h"
#include "core/project/what_to_write.h"
#include "core/quantity/distribution.h"
#include "core/setup/column_words.h"
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
    SetupValue refuse(const Message& message, const std::string& below = {}) {
        context_.problems.error(path_ + below, message);
        return {};
    }
    Message title() const { return in_quotes(Message::declared(field_.title)); }

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
            return refuse(
                tell<"%1 is a table: it needs \"columns\" and \"rows\", or the name of a \"csv\" file">(
                    title()));
        return columns && rows ? inline_table(*columns, *rows) : SetupValue{};
    }

private:
    SetupValue inline_table(const Json& columns, const Json& rows) {
        std::vector<std::string> headers;
        for (const Json& column : columns) {
            if (!column.is_string())
                return refuse(tell<"the columns of %1 must be texts in quotes">(title()), "/columns");
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

        if (!row.is_array() || row.size() != columns.target.size()) {
            refuse(row.is_array() ? tell<"row %1 of %2 has %3 cells; there are %4 columns">(
                                        index + 1, title(), row.size(), columns.target.size())
                                  : tell<"row %1 of %2 must be a list in brackets, not %3">(
                                        index + 1, title(), json_words(row)),
                   place);
            return cells;
        }
        for (std::size_t i = 0; i < row.size(); ++i) {
            const ColumnSpec& column = field_.columns[columns.target[i]];
            if (auto cell = read_cell(row[i], column.kind))
                cells[columns.target[i]] = *cell;
            else
                refuse(
                    tell<"'%1' in row %2 of %3 must be %4, not %5: %6">(
                        column_title(column), index + 1, title(), cell_words(column.kind), json_words(row[i]),
                        cell_to_write(row[i], column.kind, columns.units[columns.target[i]])),
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

    static Message cell_words(FieldKind kind) {
        if (kind == FieldKind::number || kind == FieldKind::integer) return tell<"a number">();
        return kind == FieldKind::flag ? tell<"true or false">() : tell<"a text in quotes">();
    }

    bool read_csv_columns(const Json& columns, CsvColumns& renamed) {
        if (!columns.is_object()) {
            refuse(
                tell<
                    "the columns of the CSV file of %1 must be an object in braces: a header of the file and "
                    "the column it stands for">(title()),
                "/columns");
            return false;
        }
        for (const auto& [header, column] : columns.items()) {
            if (!column.is_string()) {
                refuse(tell<"'%1' must stand for a column of %2 (a text), or for none (an empty text)">(
                           header, title()),
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
            return refuse(
                tell<"the CSV file '%1' of %2 must be named relative to the project's folder and lie in it">(
                    name, title()),
                "/csv");
        if (is_led_out_of(context_.directory, relative))
            return refuse(
                tell<"the CSV file '%1' of %2 is a link that leads out of the project's folder: put "
                     "the file itself there">(name, title()),
                "/csv");
        const fs::path file = context_.directory / relative;
        std::error_code ignored;
        if (!fs::exists(file, ignored))
            return refuse(tell<"the CSV file of %1 does not exist: looked for '%2'">(title(), file.string()),
                          "/csv");
        CsvTable read = table_from_csv_file(file, field_, renamed);
        for (Problem& problem : read.problems.items()) {
            problem.path = path_;
            problem.message = tell<"CSV file of %1: %2">(title(), problem.message);
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
            return refuse(tell<"%1 must be a whole number, not %2">(title(), json_words(value)));
        if (value.is_number())
            return refuse(tell<"%1 is %2; its unit is missing: write {\"value\": %3, \"unit\": \"%4\"}">(
                title(), dimension_words(field_.unit), shortest_number(value.get<double>()),
                field_.unit.text()));
        if (!value.is_object())
            return refuse(tell<"%1 must be a number, not %2: %3">(title(), json_words(value),
                                                                  number_to_write(value, field_.unit)));
        const auto quantity = quantity_from(value, path_, context_.problems);
        return quantity ? SetupValue(*quantity) : SetupValue{};
    }

    SetupValue text(const Json& value) {
        if (field_.several_lines && value.is_array()) return lines(value);
        if (!value.is_string())
            return refuse(tell<"%1 must be a text in quotes, not %2">(title(), json_words(value)));
        return value.get<std::string>();
    }

    SetupValue lines(const Json& list) {
        std::string text;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (!list[i].is_string() || list[i].get<std::string>().find('\n') != std::string::npos)
                return refuse(tell<"the lines of %1 must be texts in quotes, each one line">(title()),
                              "/" + std::to_string(i));
            text += (i == 0 ? "" : "\n") + list[i].get<std::string>();
        }
        return text;
    }

    SetupValue flag(const Json& value) {
        if (!value.is_boolean())
            return refuse(tell<"%1 must be true or false, not %2: %3">(
                title(), json_words(value), cell_to_write(value, FieldKind::flag, Unit())));
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
            refuse(tell<"'%1' of %2 must be a list of three numbers">(key, title()), list ? "/" + key : "");
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
    ObjectReader reader(value, path, tell<"this set-up">(), context.problems);
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
