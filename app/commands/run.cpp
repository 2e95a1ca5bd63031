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

/// Evaluates one project and writes everything that was asked for. Its result lines are added.
Result<void> run_one(const RunArguments& arguments, const std::stop_token& stop, const NamedRun& named,
                     std::string& lines) {
    if (auto made = make_output_folder(arguments.outputs.folder); !made) return made;
    EarlierResults earlier(arguments.outputs.folder);
    const RunRequest& request = arguments.request;
    auto opened = open_project(request.file, request.values, request.analyses);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, request, stop);
    if (!evaluation) return fail(evaluation.error());
    lines += result_lines(named, (*opened)->project(), *evaluation);
    if (auto written =
            write_run_outputs(arguments.outputs, **opened, *evaluation, !request.analyses.empty(), stop);
        !written)
        return written;
    earlier.are_replaced();
    return check_complete(*evaluation);
}

/// "blocks.csv:18: row 17 (0815)"
std::string place_of(const RunArguments& arguments, const ValueRow& row) {
    return arguments.set_from + ":" + std::to_string(row.line) + ": row " + std::to_string(row.number) +
           " (" + row.name + ")";
}

RunArguments with_values_of(const ValueRow& row, RunArguments arguments) {
    arguments.request.values.insert(arguments.request.values.end(), row.values.begin(), row.values.end());
    return arguments;
}

/// Errors of each row, before the first is run; empty: none.
std::vector<std::string> wrong_rows(const RunArguments& arguments, const std::vector<ValueRow>& rows,
                                    const std::stop_token& stop) {
    std::vector<std::string> wrong;
    for (const ValueRow& row : rows) {
        if (stop.stop_requested()) break;
        const RunRequest request = with_values_of(row, arguments).request;
        const auto errors = errors_of_project(request.file, request.values, request.analyses);
        std::string& words = wrong.emplace_back();
        if (!errors) words = errors.error().message.english();
        if (errors && errors->has_errors()) {
            const Problem& first = errors->items().front();
            words = (first.path.empty() ? "" : first.path + ": ") + first.message.english();
        }
        if (!words.empty()) print_message(place_of(arguments, row) + ": " + words);
    }
    wrong.resize(rows.size());
    return wrong;
}

/// A run for each row of the table, in a folder of its name; all result lines in results.csv. The table is
/// checked first. A row that fails is said and does not keep the others from being run.
Result<void> run_rows(const RunArguments& arguments, const std::stop_token& stop) {
    const auto rows = read_value_rows(arguments.set_from);
    if (!rows) return fail(rows.error());
    if (auto made = make_output_folder(arguments.outputs.folder); !made) return made;
    const std::vector<std::string> wrong = wrong_rows(arguments, *rows, stop);
    std::string lines = result_lines_head();
    FileNames folders;
    std::size_t failed = 0;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const ValueRow& row = (*rows)[i];
        const NamedRun named{row.name, folders.unique(file_name_part(row.name), "")};
        RunArguments one = with_values_of(row, arguments);
        one.outputs.folder += "/" + named.folder;
        if (!wrong[i].empty()) {
            EarlierResults(one.outputs.folder);
            lines += line_without_results({row.name, ""}, wrong[i]);
            ++failed;
            continue;
        }
        std::string own;
        const auto done = run_one(one, stop, named, own);
        if (!done && done.error().code == ErrorCode::cancelled) return done;
        if (!done) print_message(place_of(arguments, row) + ": " + done.error().message.english());
        if (!done && own.empty()) own = line_without_results(named, done.error().message.english());
        lines += own;
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
    return run_one(arguments, stop, {}, lines);
}

}  // namespace

Command run_command(CLI::App& app) {
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* command = app.add_subcommand("run", "Evaluate a project; write results.json and CSV tables");
    add_examples(*command,
                 {{"run projects/stewart-platform.covaria --trials 1e5 --out out"},
                  {"run projects/stewart-platform.covaria --analysis printed --first-order --report",
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
