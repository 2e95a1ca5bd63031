#include "ui/document/missing_fields.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "core/setup/setup_schema.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {
namespace {

constexpr int longest_chain = 32;  ///< limit of references followed; circles are errors of their own

const Setup* setup_of(const Project& project, const SetupAddress& address) {
    if (address.owner == SetupOwner::asset) {
        const AssetEntry* asset = project.find_asset(address.id);
        return asset ? &asset->setup : nullptr;
    }
    const AnalysisEntry* analysis = project.find_analysis(address.id);
    return analysis ? &analysis->setup : nullptr;
}

/// "/analyses/0/setup/base_points/rows/2" -> "base_points"
std::string field_in(const std::string& path, const std::string& entry) {
    const std::string before = entry + "/setup/";
    if (!path.starts_with(before)) return {};
    return path.substr(before.size(), path.find('/', before.size()) - before.size());
}

bool is_empty(const SetupValue& value) {
    const auto* table = std::get_if<SetupTable>(&value);
    return std::holds_alternative<std::monostate>(value) ||
           (table && table->rows.empty() && table->csv_file.empty());
}

/// "/analyses/0/setup/quantities/rows/2/value": a cell in which nothing stands, of a row that is begun.
bool is_empty_cell(const FieldSpec& field, const SetupTable& table, const std::string& path) {
    const auto rows = path.find("/rows/");
    if (rows == std::string::npos) return false;
    char* end = nullptr;
    const unsigned long row = std::strtoul(path.c_str() + rows + 6, &end, 10);
    if (*end != '/' || row >= table.rows.size()) return false;
    const std::size_t column = SetupSchema::column(field, end + 1);
    return column < field.columns.size() && column < table.rows[row].size() &&
           std::holds_alternative<std::monostate>(table.rows[row][column]);
}

/// Character at "/analyses/0/setup/equations/2/8-8"; '\0' behind the end of its line. Empty: no columns.
std::optional<char> character_at(const std::string& text, const std::string& path) {
    const std::size_t columns = path.rfind('/'), line = path.rfind('/', columns - 1);
    if (path.find('-', columns) == std::string::npos) return std::nullopt;
    std::istringstream lines(text);
    std::string found;
    for (int i = std::atoi(path.c_str() + line + 1); i >= 0; --i)
        if (!std::getline(lines, found)) found.clear();
    int left = std::atoi(path.c_str() + columns + 1);  // characters of UTF-8 up to the place, from 1
    const auto at = std::ranges::find_if(
        found, [&left](unsigned char byte) { return (byte & 0xc0U) != 0x80U && --left == 0; });
    return at == found.end() ? '\0' : *at;
}

/// Whether a text is still being typed: it ends too soon, a parenthesis is open, or a name has no row yet.
bool is_begun(const Project& project, const SetupAddress& address, const std::string& text,
              const std::string& path) {
    const std::optional<char> at = character_at(text, path);
    if (!at) return false;
    const bool is_open = *at == '(' && std::ranges::count(text, '(') > std::ranges::count(text, ')');
    const auto byte = static_cast<unsigned char>(*at);
    const auto completed =
        byte >= 0x80 || std::isalpha(byte) ? completed_setup(project, address) : std::nullopt;
    return *at == '\0' || is_open || (completed && !(*completed == *setup_of(project, address)));
}

Lack lack(const Project& project, const Problems& all, const std::string& entry, int depth);

bool refers_to_unfinished(const Project& project, const Problems& all, const std::string& id, int depth) {
    for (const SetupAddress& address : {SetupAddress{SetupOwner::asset, id}, {SetupOwner::analysis, id}}) {
        if (!setup_of(project, address)) continue;
        return lack(project, all, entry_path(project, address), depth + 1) == Lack::fields;
    }
    return false;
}

bool missing(const Project& project, const Problems& all, const Problem& problem, int depth) {
    const SetupAddress address = address_of_path(project, problem.path);
    const Setup* setup = setup_of(project, address);
    const SetupSchema* schema = setup ? find_schema(project, address) : nullptr;
    if (!schema || depth > longest_chain) return false;
    const FieldSpec* field = schema->find(field_in(problem.path, entry_path(project, address)));
    if (!field) return false;
    const SetupValue& value = value_of(*field, *setup);
    if (is_empty(value) || setup->values.empty()) return true;
    if (const auto* table = std::get_if<SetupTable>(&value))
        return is_empty_cell(*field, *table, problem.path);
    const auto* text = std::get_if<std::string>(&value);
    if (text && field->several_lines) return is_begun(project, address, *text, problem.path);
    return text && field->kind == FieldKind::reference && refers_to_unfinished(project, all, *text, depth);
}

Lack lack(const Project& project, const Problems& all, const std::string& entry, int depth) {
    Lack found = Lack::nothing;
    for (const Problem& problem : all.items()) {
        if (problem.severity != Severity::error) continue;
        if (problem.path != entry && !problem.path.starts_with(entry + '/')) continue;
        if (!missing(project, all, problem, depth)) return Lack::other;
        found = Lack::fields;
    }
    return found;
}

std::optional<MissingField> next(const Project& project, const Problems& all, const std::string& entry,
                                 int depth) {
    for (const Problem& problem : all.items()) {
        const bool inside = problem.path == entry || problem.path.starts_with(entry + '/');
        if (!inside || problem.severity != Severity::error || !missing(project, all, problem, depth))
            continue;
        const SetupAddress address = address_of_path(project, problem.path);
        const FieldSpec* field = find_schema(project, address)->find(field_in(problem.path, entry));
        const SetupValue& value = value_of(*field, *setup_of(project, address));
        const bool is_table = std::holds_alternative<SetupTable>(value);  // a cell of it is empty
        const bool has_place = is_table || field->several_lines;
        if (has_place || is_empty(value) || setup_of(project, address)->values.empty())
            return MissingField{field->title, problem.path};
        const std::string& id = std::get<std::string>(value);
        for (const SetupAddress& used : {SetupAddress{SetupOwner::asset, id}, {SetupOwner::analysis, id}})
            if (setup_of(project, used)) return next(project, all, entry_path(project, used), depth + 1);
    }
    return {};
}

}  // namespace

bool is_missing(const Project& project, const Problems& all, const Problem& problem) {
    return missing(project, all, problem, 0);
}

std::optional<MissingField> next_missing(const Project& project, const Problems& all,
                                         const std::string& entry) {
    return next(project, all, entry, 0);
}

Lack lack_of(const Project& project, const Problems& all, const std::string& entry) {
    return lack(project, all, entry, 0);
}

}  // namespace covaria::ui
