#include "core/project/remedies.h"

#include <nlohmann/json.hpp>

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

}  // namespace

Result<Project> mended(const Project& project, const Remedy& remedy) {
    std::vector<ValueAt> values;
    for (const Remedy::Value& value : remedy.values) values.push_back({value.place, remedy_json(value)});
    const Result<std::string> text = with_values(project_text(project), values);
    if (!text) return fail(text.error());
    ReadProject read = read_project(*text, project.directory, "");
    for (const Problem& problem : read.problems.items())
        if (problem.severity == Severity::error)
            return fail(ErrorCode::bad_input, problem.message, problem.path);
    read.project.directory = project.directory;
    return std::move(read.project);
}

}  // namespace covaria
