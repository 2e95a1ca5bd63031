// covaria merge DIR: the results of a run whose parts were computed elsewhere.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/merged_run.h"
#include "app/output_folder.h"
#include "app/run_outputs.h"
#include "app/terminal.h"

namespace covaria {
namespace {

struct MergeArguments {
    std::string parts;
    std::string project;
    RunOutputs outputs;
    int threads = 0;
    bool resume = false;
};

Result<void> merge(const MergeArguments& arguments, const std::stop_token& stop) {
    const auto folder = PartsFolder::open(arguments.parts);
    if (!folder) return fail(folder.error());
    if ((*folder)->empty())
        return fail(ErrorCode::not_found, arguments.parts + ": there are no parts (*.part) in this folder");
    auto request = request_of((*folder)->request(), arguments.project);
    if (!request) return fail(request.error());
    request->threads = arguments.threads;
    const auto run = open_shared_run(*request);
    if (!run) return fail(run.error());
    if (auto made = make_output_folder(arguments.outputs.folder); !made) return made;
    EarlierResults earlier(arguments.outputs.folder);
    const MissingUnits missing{arguments.resume ? MissingUnits::Rule::compute : MissingUnits::Rule::refuse};
    const auto evaluation = merge_units(*run, **folder, missing, stop);
    if (!evaluation) return fail(evaluation.error());
    if (auto written =
            write_run_outputs(arguments.outputs, *run->opened, *evaluation, !request->analyses.empty(), stop);
        !written)
        return written;
    earlier.are_replaced();
    return check_complete(*evaluation);
}

}  // namespace

Command merge_command(CLI::App& app) {
    auto arguments = std::make_shared<MergeArguments>();
    CLI::App* command = app.add_subcommand(
        "merge", "Put the parts of a run together; the results have the bits of covaria run");
    add_examples(*command, {{"merge parts --out out"}});
    command->add_option("PARTS", arguments->parts, "folder of parts (covaria part, covaria-mpi)")
        ->type_name("DIR")
        ->required();
    command
        ->add_option("--project", arguments->project,
                     "the project file, where it is not at the place it had when the parts were made")
        ->type_name("FILE");
    command->add_flag("--resume", arguments->resume, "compute the units that no part has, and keep them too");
    add_threads_option(*command, arguments->threads);
    add_output_options(*command, arguments->outputs);
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = merge(*arguments, stop);
                if (!done) {
                    print_error(done.error());
                    return exit_status_of(done.error());
                }
                std::printf("results are in %s\n", arguments->outputs.folder.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
