#include "core/project/remedies.h"

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/project/kind_lookup.h"
#include "core/project/project_file.h"
#include "core/project/set_values.h"

namespace covaria {

namespace {

std::string remedy_json(const Remedy::Value& value) {
    nlohmann::json json;
    if (const auto* number = std::get_if<double>(&value.value)) json = *number;
    if (const auto* text = std::get_if<std::string>(&value.value)) json = *text;
    return json.dump();
}

SetupCell cell_of(const Remedy::Value& value) {
    return std::visit([](const auto& held) { return SetupCell(held); }, value.value);
}

/// Puts the value into the cell of a table: "/analyses/0/setup/readings/rows/3/use". False: its place is none
/// of a cell.
bool put_into_table(Project& project, const Remedy::Value& value) {
    std::vector<std::string> names;
    std::istringstream parts(value.place);
    for (std::string name; std::getline(parts, name, '/');) names.push_back(name);
    if (names.size() != 8 || names[3] != "setup" || names[5] != "rows") return false;
    const auto number = [](const std::string& text) {
        std::size_t read = std::numeric_limits<std::size_t>::max();
        std::from_chars(text.data(), text.data() + text.size(), read);
        return read;
    };
    const auto put = [&](auto& entries) {
        if (number(names[2]) >= entries.size()) return false;
        auto& entry = entries[number(names[2])];
        const SetupSchema* schema = schema_of(entry);
        const FieldSpec* field = schema ? schema->find(names[4]) : nullptr;
        const auto held = entry.setup.values.find(names[4]);
        auto* table = held == entry.setup.values.end() ? nullptr : std::get_if<SetupTable>(&held->second);
        const std::size_t row = number(names[6]);
        const std::size_t column = field ? SetupSchema::column(*field, names[7]) : 0;
        if (!field || !table || row >= table->rows.size() || column >= field->columns.size()) return false;
        table->csv_file.clear();
        table->csv_columns.clear();
        if (table->rows[row].size() <= column) table->rows[row].resize(column + 1);
        table->rows[row][column] = cell_of(value);
        return true;
    };
    return names[1] == "analyses" ? put(project.analyses) : names[1] == "assets" && put(project.assets);
}

}  // namespace

Result<Project> mended(const Project& project, const Remedy& remedy) {
    Project made = project;
    std::vector<ValueAt> values;
    for (const Remedy::Value& value : remedy.values)
        if (!put_into_table(made, value)) values.push_back({value.place, remedy_json(value)});
    if (values.empty()) return made;
    const Result<std::string> text = with_values(project_text(made), values);
    if (!text) return fail(text.error());
    ReadProject read = read_project(*text, project.directory, "");
    for (const Problem& problem : read.problems.items())
        if (problem.severity == Severity::error)
            return fail(ErrorCode::bad_input, problem.message, problem.path);
    read.project.directory = project.directory;
    return std::move(read.project);
}

}  // namespace covaria
