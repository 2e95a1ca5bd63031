// covaria run FILE: evaluates a project and writes results.json and CSV tables; on request report and
// pictures too.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/pictures.h"
#include "app/report_files.h"
#include "app/result_lines.h"
#include "app/terminal.h"
#include "app/value_rows.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/report/result_files.h"
#include "core/result/representation.h"

namespace covaria {
namespace {

struct RunArguments {
    RunRequest request;
    std::string out = "out";
    std::string set_from;
    bool report = false;
    bool certificate = false;
    bool pictures = false;
};

void say_what_does_not_represent(const Project& project, const std::vector<EvaluatedAnalysis>& analyses) {
    for (const EvaluatedAnalysis& one : analyses) {
        if (represents_measurand(*one.result)) continue;
        const AnalysisEntry* entry = project.find_analysis(one.analysis->id);
        const bool required = entry && !entry->requirements.empty();
        print_message("the result of " + one.analysis->id + " " + does_not_represent +
                      (required ? "; its requirements are not judged" : ""));
    }
}

Result<void> write_documents(const RunArguments& arguments, const ReportSource& source,
                             const std::stop_token& stop) {
    const bool chosen = !arguments.request.analyses.empty();
    const auto write = [&](DocumentKind kind, const char* name) {
        ReportFiles files{arguments.out};
        files.name = name;
        return write_document(build_document(kind, source.made, source.analyses, source.failed, chosen),
                              source, files, stop);
    };
    if (arguments.report)
        if (auto written = write(DocumentKind::report, "report"); !written) return written;
    if (!arguments.certificate) return {};
    say_what_is_missing(source.made.project());
    return write(DocumentKind::certificate, "certificate");
}

/// Evaluates one project and writes everything that was asked for. `lines`: its result lines are added, under
/// `name`.
Result<void> run_one(const RunArguments& arguments, const std::stop_token& stop, const std::string& name,
                     std::string& lines) {
    if (auto made = make_output_folder(arguments.out); !made) return made;
    auto opened = open_project(arguments.request.file, arguments.request.values);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    const std::vector<EvaluatedAnalysis>& analyses = evaluation->analyses;
    say_what_does_not_represent((*opened)->project(), analyses);
    ResultListing listing{evaluation->failed, {}};
    std::vector<PlannedPicture> pictures;
    if (arguments.pictures) pictures = planned_pictures(analyses);
    for (const PlannedPicture& picture : pictures) listing.files.push_back(listed(picture, analyses));
    if (auto written = write_result_files(arguments.out, *evaluation->made, analyses, std::move(listing));
        !written)
        return written;
    if (auto written = write_pictures(arguments.out, analyses, pictures, stop); !written) return written;
    if (auto written = write_documents(arguments, {*evaluation->made, analyses, evaluation->failed}, stop);
        !written)
        return written;
    lines += result_lines(name, (*opened)->project(), analyses);
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
        one.out += "/" + folders.unique(file_name_part(row.name), "");
        one.request.values.insert(one.request.values.end(), row.values.begin(), row.values.end());
        const auto done = run_one(one, stop, row.name, lines);
        if (!done && done.error().code == ErrorCode::cancelled) return done;
        if (!done) print_error(done.error());
        failed += !done;
    }
    if (auto written = write_file_atomically(arguments.out + "/results.csv", lines); !written) return written;
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
    add_run_options(*command, arguments->request);
    command->add_option("--out", arguments->out, "folder for the results")
        ->type_name("DIR")
        ->capture_default_str();
    command
        ->add_option("--set-from", arguments->set_from,
                     "a CSV table with a run in each row: one column names it (serial number), the others "
                     "are places as --set has "
                     "them; results in DIR/NAME, all result lines in DIR/results.csv")
        ->type_name("CSV");
    command->add_flag("--report", arguments->report, "write the report too (PDF, HTML, Markdown)");
    command->add_flag("--certificate", arguments->certificate,
                      "write a calibration certificate too (PDF, HTML, Markdown): the project's section "
                      "\"certificate\" and the results");
    command->add_flag("--pictures", arguments->pictures, "write pictures of every analysis too (PNG)");
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = run(*arguments, stop);
                if (!done) {
                    print_error(done.error());
                    return exit_status_of(done.error());
                }
                std::printf("results are in %s\n", arguments->out.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
