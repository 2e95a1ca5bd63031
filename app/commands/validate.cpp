// covaria validate FILE: every problem of a project, one a line.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/made/certificate_gaps.h"
#include "core/made/load_project.h"

namespace covaria {
namespace {

struct ValidateArguments {
    std::string file;
    std::vector<std::string> values = {};
    bool certificate = false;
};

int validate(const ValidateArguments& arguments) {
    const auto values = values_at(arguments.values);
    if (!values) {
        print_error(values.error());
        return exit_status_of(values.error());
    }
    LoadedProject loaded = load_project(arguments.file, *values);
    if (arguments.certificate && loaded.made) {
        for (Problem& problem : loaded.problems.items())
            if (problem.path.starts_with("/certificate/")) problem.severity = Severity::error;
        loaded.problems.take(missing_in(*loaded.made, certified_ids(loaded.project)), "");
    }
    print_problems(loaded.problems);
    if (loaded.problems.has_errors()) return exit_bad_input;
    std::printf("%s: %zu assets, %zu analyses, %sno errors\n", arguments.file.c_str(),
                loaded.project.assets.size(), loaded.project.analyses.size(),
                arguments.certificate ? "a certificate with all that is required, " : "");
    return exit_success;
}

}  // namespace

Command validate_command(CLI::App& app) {
    auto arguments = std::make_shared<ValidateArguments>();
    CLI::App* command =
        app.add_subcommand("validate", "Check a project; print every problem with its place, one a line");
    command->add_option("FILE", arguments->file, "project file (*.covaria)")->required();
    command->add_flag("--certificate", arguments->certificate,
                      "what ISO/IEC 17025 7.8.2 and 7.8.4 require of a certificate is missing: an error too");
    command
        ->add_option("--set", arguments->values,
                     "a value of the project file: /certificate/item/serialNumber=17 (may be repeated)")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    return {command, [arguments](const std::stop_token&) { return validate(*arguments); }};
}

}  // namespace covaria
