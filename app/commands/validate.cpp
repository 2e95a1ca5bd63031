// covaria validate FILE: every problem of a project, one a line.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/terminal.h"
#include "core/made/certificate_gaps.h"
#include "core/made/load_project.h"

namespace covaria {
namespace {

struct ValidateArguments {
    std::string file;
    std::vector<std::string> values = {};
    bool certificate = false, json = false;
};

std::string validation_json(const std::string& file, const LoadedProject& loaded) {
    OrderedJson json = json_document("covaria-validation");
    json["file"] = file;
    json["valid"] = !loaded.problems.has_errors();
    json["assets"] = loaded.project.assets.size();
    json["analyses"] = loaded.project.analyses.size();
    json["problems"] = problems_json(loaded.problems);
    return json_text(json);
}

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
    if (arguments.json) {
        std::fputs(validation_json(arguments.file, loaded).c_str(), stdout);
        return loaded.problems.has_errors() ? exit_bad_input : exit_success;
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
    add_examples(*command, {{"validate projects/stewart-platform.covaria"},
                            {"validate projects/certificate-gauge-block.covaria --certificate",
                             "what a certificate lacks too"},
                            {"validate projects/gum/h1-end-gauge.covaria --json", "for programs"}});
    command->add_option("FILE", arguments->file, "project file (*.covaria)")->required();
    command->add_flag("--certificate", arguments->certificate,
                      "what ISO/IEC 17025 7.8.2 and 7.8.4 require of a certificate is missing: an error too");
    command
        ->add_option("--set", arguments->values,
                     "a value of the project file: /certificate/item/serialNumber=17 (may be repeated)")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    add_json_option(*command, arguments->json);
    return {command, [arguments](const std::stop_token&) { return validate(*arguments); }};
}

}  // namespace covaria
