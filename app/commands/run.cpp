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
#include "app/terminal.h"
#include "core/report/result_files.h"
#include "core/result/representation.h"

namespace covaria {
namespace {

struct RunArguments {
    RunRequest request;
    std::string out = "out";
    bool report = false;
    bool pictures = false;
};

Result<void> run(const RunArguments& arguments, const std::stop_token& stop) {
    if (auto made = make_output_folder(arguments.out); !made) return made;
    auto opened = open_project(arguments.request.file);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    const std::vector<EvaluatedAnalysis>& analyses = evaluation->analyses;
    for (const EvaluatedAnalysis& one : analyses)
        if (!represents_measurand(*one.result))
            print_message("the result of " + one.analysis->id + " " + does_not_represent);
    ResultListing listing{evaluation->failed, {}};
    std::vector<PlannedPicture> pictures;
    if (arguments.pictures) pictures = planned_pictures(analyses);
    for (const PlannedPicture& picture : pictures) listing.files.push_back(listed(picture, analyses));
    if (auto written = write_result_files(arguments.out, **opened, analyses, std::move(listing)); !written)
        return written;
    if (auto written = write_pictures(arguments.out, analyses, pictures, stop); !written) return written;
    if (arguments.report)
        if (auto written = write_reports({**opened, analyses, evaluation->failed}, {arguments.out}, stop);
            !written)
            return written;
    return check_complete(*evaluation);
}

}  // namespace

Command run_command(CLI::App& app) {
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* command = app.add_subcommand("run", "Evaluate a project; write results.json and CSV tables");
    add_run_options(*command, arguments->request);
    command->add_option("--out", arguments->out, "folder for the results")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_flag("--report", arguments->report, "write the report too (PDF, HTML, Markdown)");
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
