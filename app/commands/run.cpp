// covaria run FILE: evaluates a project and writes results.json and CSV tables; on request report and
// pictures too.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/result_lines.h"
#include "app/run_outputs.h"
#include "app/terminal.h"
#include "app/value_rows.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"

namespace covaria {
namespace {

struct RunArguments {
    RunRequest request;
    std::string set_from;
    RunOutputs outputs;
};

/// Evaluates one project and writes everything that was asked for. `lines`: its result lines are added, under
/// `name`.
Result<void> run_one(const RunArguments& arguments, const std::stop_token& stop, const std::string& name,
                     std::string& lines) {
    if (auto made = make_output_folder(arguments.outputs.folder); !made) return made;
    auto opened = open_project(arguments.request.file, arguments.request.values);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    if (auto written = write_run_outputs(arguments.outputs, **opened, *evaluation,
                                         !arguments.request.analyses.empty(), stop);
        !written)
        return written;
    lines += result_lines(name, (*opened)->project(), evaluation->analyses);
    return check_complete(*evaluation);
}

/// A run for each row of the table, in a folder of its name; all result lines in results.csv. A row that
/// fails is said and does not keep the others from being run.
Result<void> run_rows(const RunArguments& arguments, const std::stop_token& stop) {
    const auto rows = read_value_rows(arguments.set_from);
    if (!rows) return fail(rows.error());
    std::string lines = result_lines_head();
    FileNames folders;
    std::size_t failed = 0;
    for (const ValueRow& row : *rows) {
        RunArguments one = arguments;
        one.outputs.folder += "/" + folders.unique(file_name_part(row.name), "");
        one.request.values.insert(one.request.values.end(), row.values.begin(), row.values.end());
        const auto done = run_one(one, stop, row.name, lines);
        if (!done && done.error().code == ErrorCode::cancelled) return done;
        if (!done) print_error(done.error());
        failed += !done;
    }
    if (auto written = write_file_atomically(arguments.outputs.folder + "/results.csv", lines); !written)
        return written;
    if (failed == 0) return {};
    return fail(ErrorCode::bad_input, std::to_string(failed) + " of " + std::to_string(rows->size()) +
                                          " rows without all their results");
}

Result<void> run(const RunArguments& arguments, const std::stop_token& stop) {
    if (!arguments.set_from.empty()) return run_rows(arguments, stop);
    std::string lines;
    return run_one(arguments, stop, "", lines);
}

}  // namespace

Command run_command(CLI::App& app) {
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* command = app.add_subcommand("run", "Evaluate a project; write results.json and CSV tables");
    add_examples(*command, {{"run projects/stewart-platform.covaria --out out"},
                            {"run projects/stewart-platform.covaria --analysis printed --trials 1e5 --report",
                             "one analysis, its report too"},
                            {"run projects/gum/h1-end-gauge.covaria --first-order --set "
                             "/analyses/table/setup/quantities/rows/l_S/a=150",
                             "with another value, which the file keeps not"}});
    add_run_options(*command, arguments->request);
    add_output_options(*command, arguments->outputs);
    command
        ->add_option("--set-from", arguments->set_from,
                     "a CSV table with a run in each row: one column names it (serial number), the others "
                     "are places as --set has "
                     "them; results in DIR/NAME, all result lines in DIR/results.csv")
        ->type_name("CSV");
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = run(*arguments, stop);
                if (!done) {
                    print_error(done.error());
                    return exit_status_of(done.error());
                }
                std::printf("results are in %s\n", arguments->outputs.folder.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
