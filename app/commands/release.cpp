// covaria release FILE: releases a project with the names of its review, or adds a line to its log.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/saved_project.h"
#include "app/terminal.h"
#include "core/made/load_project.h"
#include "core/project/release.h"
#include "ui/document/today.h"

namespace covaria {
namespace {

struct ReleaseArguments {
    std::string file, output;
    std::string prepared, checked, released;
    std::string date;
    std::string line, by;  ///< a line of the log, and whose it is

    bool has_names() const { return !prepared.empty() || !checked.empty() || !released.empty(); }
};

Result<void> check_arguments(const ReleaseArguments& arguments) {
    if (!arguments.by.empty() && arguments.line.empty())
        return fail(ErrorCode::usage, "--by says whose line of the log it is: give the line too (--log)");
    if (!arguments.line.empty() && arguments.by.empty())
        return fail(ErrorCode::usage, "say whose line of the log it is (--by NAME)");
    if (!arguments.line.empty() && arguments.has_names())
        return fail(ErrorCode::usage,
                    "a line of the log is written without a release: leave out --log, or the names");
    return {};
}

/// Takes a name that was given; one that the project has keeps its date.
void take_step(ReviewStep& step, const std::string& name, const std::string& date) {
    if (!name.empty()) step = {name, date};
    if (!step.name.empty() && step.date.empty()) step.date = date;
}

Result<void> change(Project& project, const ReleaseArguments& arguments) {
    const std::string date = arguments.date.empty() ? ui::today() : arguments.date;
    if (!arguments.line.empty()) {
        project.review.log.push_back({date, arguments.by, arguments.line});
        Problems problems;
        check_review(project.review, problems);
        return problems.has_errors() ? Result<void>(fail(ErrorCode::bad_input, first_error(problems, "")))
                                     : Result<void>{};
    }
    // After a change the release is a new one, of that day, by whomever.
    ReviewStep& released = project.review.released;
    if (release_status(project).state == ReleaseState::changed) released.date = date;
    take_step(project.review.prepared, arguments.prepared, date);
    take_step(project.review.checked, arguments.checked, date);
    take_step(released, arguments.released, date);
    return release(project);
}

Result<void> release_file(const ReleaseArguments& arguments) {
    if (auto right = check_arguments(arguments); !right) return right;
    LoadedProject loaded = load_project(arguments.file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::bad_input, arguments.file + ": the project has errors; it was not released");
    if (auto changed = change(loaded.project, arguments); !changed) return changed;
    const std::string& file = arguments.output.empty() ? arguments.file : arguments.output;
    if (auto saved = save_with_tables(loaded.project, file); !saved) return saved;
    std::printf("%s: %s\n", file.c_str(),
                words_of(release_status(loaded.project), loaded.project.review).english().c_str());
    return {};
}

}  // namespace

Command release_command(CLI::App& app) {
    auto arguments = std::make_shared<ReleaseArguments>();
    CLI::App* command = app.add_subcommand(
        "release",
        "Release a project: who prepared, checked and released it, and the digest of what it says");
    add_examples(
        *command,
        {{"release order.covaria --prepared 'A. Ames' --checked 'B. Bell' --released 'C. Cole'",
          "the date is today's; names that the project has need not be given"},
         {"release order.covaria --log 'Sent to the customer' --by 'A. Ames'", "a line of the log alone"}},
        "The digest (SHA-256) covers everything that numbers depend on or documents say. Any edit makes the "
        "project a draft again:\n"
        "covaria check, verify-report, reports and certificates say what has changed since.");
    command->add_option("FILE", arguments->file, "project file (*.covaria)")->required();
    command->add_option("--prepared", arguments->prepared, "who prepared it")->type_name("NAME");
    command->add_option("--checked", arguments->checked, "who checked it")->type_name("NAME");
    command->add_option("--released", arguments->released, "who releases it")->type_name("NAME");
    command->add_option("--date", arguments->date, "the date of all that is given: 2026-04-17")
        ->type_name("DATE");
    command->add_option("--log", arguments->line, "write a line into the log; nothing is released")
        ->type_name("TEXT");
    command->add_option("--by", arguments->by, "whose line it is")->type_name("NAME");
    command->add_option("-o,--output", arguments->output, "project to write; without it FILE itself")
        ->type_name("FILE");
    return {command, [arguments](const std::stop_token&) {
                const auto done = release_file(*arguments);
                if (done) return int(exit_success);
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
