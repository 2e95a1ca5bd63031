// covaria validate FILE: every problem of a project, one a line.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/made/load_project.h"

namespace covaria {
namespace {

int validate(const std::string& file) {
    const LoadedProject loaded = load_project(file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors()) return exit_bad_input;
    std::printf("%s: %zu assets, %zu analyses, no errors\n", file.c_str(), loaded.project.assets.size(),
                loaded.project.analyses.size());
    return exit_success;
}

}  // namespace

Command validate_command(CLI::App& app) {
    auto file = std::make_shared<std::string>();
    CLI::App* command =
        app.add_subcommand("validate", "Check a project; print every problem with its place, one a line");
    command->add_option("FILE", *file, "project file (*.covaria)")->required();
    return {command, [file](const std::stop_token&) { return validate(*file); }};
}

}  // namespace covaria
