#include "app/extended_project.h"

#include <filesystem>

#include "app/terminal.h"
#include "core/made/load_project.h"

namespace covaria {

Result<Project> project_to_extend(const std::string& file, const std::string& title) {
    Project project;
    project.title = title;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return project;
    LoadedProject loaded = load_project(file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::bad_input, file + ": the project has errors; nothing was added to it");
    return std::move(loaded.project);
}

}  // namespace covaria
