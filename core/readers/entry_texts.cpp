#include "core/readers/entry_texts.h"

#include "core/base/utf8.h"
#include "core/kinds/registries.h"
#include "core/project/project_id.h"

namespace covaria {

std::string id_of(const std::string& name, const std::string& otherwise) {
    return project_id_of(name, otherwise, 60);
}

std::string plain_line(const std::string& name) {
    std::string plain;
    std::string_view rest = name;
    while (!rest.empty()) {
        const std::size_t valid = valid_utf8(rest);
        plain += rest.substr(0, valid);
        rest.remove_prefix(valid);
        if (rest.empty()) break;
        plain += '?';
        rest.remove_prefix(1);
    }
    std::string tidy;
    for (const char c : plain) {
        const auto u = static_cast<unsigned char>(c);
        const bool blank = u <= 32 || u == 127;
        if (!blank)
            tidy += c;
        else if (!tidy.empty() && tidy.back() != ' ')
            tidy += ' ';
    }
    if (!tidy.empty() && tidy.back() == ' ') tidy.pop_back();
    return tidy;
}

std::string plain_name(const std::string& name) {
    std::string tidy = plain_line(name);
    if (tidy.size() > 200) tidy.resize(valid_utf8(std::string_view(tidy).substr(0, 200)));
    if (!tidy.empty() && tidy.back() == ' ') tidy.pop_back();
    return tidy;
}

std::string without_ending(const std::string& file_name) {
    const std::size_t dot = file_name.rfind('.');
    return plain_name(dot == std::string::npos || dot == 0 ? file_name : file_name.substr(0, dot));
}

TableRows::TableRows(const FieldSpec& field) : field_(field) {
    for (const ColumnSpec& column : field.columns) table_.units.push_back(column.unit);
}

void TableRows::set_unit(const std::string& column, const Unit& unit) {
    table_.units.at(SetupSchema::column(field_, column)) = unit;
}

void TableRows::add(std::initializer_list<std::pair<const char*, SetupCell>> cells) {
    std::vector<SetupCell> row(field_.columns.size());
    for (const auto& [key, cell] : cells) row.at(SetupSchema::column(field_, key)) = cell;
    table_.rows.push_back(std::move(row));
}

const SetupSchema& schema_of(const std::string& kind_or_model) {
    const AssetDescriptor* kind = find_asset_kind(kind_or_model);
    return kind ? kind->schema : find_model(kind_or_model)->schema;
}

const FieldSpec& table_of(const std::string& kind_or_model, const std::string& key) {
    return *schema_of(kind_or_model).find(key);
}

}  // namespace covaria
