#include "core/project/table_columns.h"

#include <algorithm>

#include "core/project/object_reader.h"
#include "core/setup/column_words.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

struct Header {
    std::string name;
    std::string unit;  // empty where none is written
};

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t");
    const auto end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? std::string{} : text.substr(begin, end - begin + 1);
}

Header split_header(const std::string& header) {
    const std::string text = trimmed(header);
    const auto open = text.rfind('[');
    if (open == std::string::npos || text.back() != ']') return {text, {}};
    return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, text.size() - open - 2))};
}

bool is_number(const ColumnSpec& column) {
    return column.kind == FieldKind::number;
}

std::vector<std::string> column_keys(const FieldSpec& table) {
    std::vector<std::string> keys;
    for (const ColumnSpec& column : table.columns) keys.push_back(column.key);
    return keys;
}

Unit column_unit(const FieldSpec& table, const ColumnSpec& column, const std::string& text,
                 const std::string& path, Problems& problems) {
    if (!is_number(column)) {
        if (!text.empty() && text != "1")
            problems.error(path, tell<"column '%1' of '%2' has no unit; it is not a measured number">(
                                     column_title(column), Message::declared(table.title)));
        return {};
    }
    const std::size_t before = problems.items().size();
    const Unit unit = text.empty() ? Unit{} : unit_from(text, path, problems);
    if (problems.items().size() > before || unit.dimension() == column.unit.dimension()) return unit;
    problems.error(path, column_unit_objection(table, column, unit));
    return unit;
}

void require_columns(const FieldSpec& table, const std::vector<std::size_t>& target, Problems& problems) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const ColumnSpec& column = table.columns[i];
        if (column.optional || std::find(target.begin(), target.end(), i) != target.end()) continue;
        problems.error("/columns", tell<"column '%1' of '%2' is missing">(column_header(column, column.unit),
                                                                          Message::declared(table.title)));
    }
}

}  // namespace

std::optional<TableColumns> match_columns(const FieldSpec& table, const std::vector<std::string>& headers,
                                          Problems& problems) {
    const std::size_t before = problems.items().size();
    TableColumns matched;
    for (const ColumnSpec& column : table.columns) matched.units.push_back(column.unit);
    for (std::size_t i = 0; i < headers.size(); ++i) {
        const std::string path = "/columns/" + std::to_string(i);
        const Header header = split_header(headers[i]);
        const std::size_t index = find_table_column(table, header.name);
        if (index == SetupSchema::npos) {
            problems.error(path,
                           tell<"'%1' has no column '%2'%3; its columns are %4">(
                               Message::declared(table.title), header.name,
                               did_you_mean(header.name, column_keys(table)), listed(column_keys(table))));
            continue;
        }
        if (std::find(matched.target.begin(), matched.target.end(), index) != matched.target.end())
            problems.error(path, tell<"column '%1' of '%2' is given twice">(header.name,
                                                                            Message::declared(table.title)));
        matched.target.push_back(index);
        matched.units[index] = column_unit(table, table.columns[index], header.unit, path, problems);
    }
    require_columns(table, matched.target, problems);
    if (problems.items().size() > before) return std::nullopt;
    return matched;
}

std::size_t find_table_column(const FieldSpec& table, const std::string& name) {
    const std::size_t by_key = SetupSchema::column(table, name);
    if (by_key != SetupSchema::npos) return by_key;
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const ColumnSpec& column) { return column.title == name; });
    return found == table.columns.end() ? SetupSchema::npos
                                        : static_cast<std::size_t>(found - table.columns.begin());
}

std::string header_name(const std::string& header) {
    return split_header(header).name;
}

std::string column_header(const ColumnSpec& column, const Unit& unit) {
    return is_number(column) && unit != Unit{} ? column.key + " [" + unit.text() + "]" : column.key;
}

}  // namespace covaria
