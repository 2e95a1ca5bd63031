// covaria report FILE: evaluates a project and writes its report.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/report_files.h"
#include "app/terminal.h"

namespace covaria {
namespace {

struct ReportArguments {
    RunRequest request;
    ReportFiles files;
};

Result<void> report(const ReportArguments& arguments, const std::stop_token& stop) {
    if (auto made = make_output_folder(arguments.files.folder); !made) return made;
    auto opened = open_project(arguments.request.file, arguments.request.values);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    if (auto written =
            write_reports({opened->project, opened->assets, evaluation->analyses, evaluation->failed},
                          arguments.files, stop);
        !written)
        return written;
    return check_complete(*evaluation);
}

}  // namespace

Command report_command(CLI::App& app) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command =
        app.add_subcommand("report", "Evaluate a project; write its report as PDF, HTML and Markdown");
    add_run_options(*command, arguments->request);
    command->add_option("--out", arguments->files.folder, "folder for the report")
        ->type_name("DIR")
        ->capture_default_str();
    command
        ->add_option("--format", arguments->files.formats,
                     "pdf, html or markdown (may be repeated; all without it)")
        ->type_name("FORMAT")
        ->check(CLI::IsMember({"pdf", "html", "markdown"}));
    command->add_option("--paper", arguments->files.paper, "a4 or letter")
        ->type_name("SIZE")
        ->check(CLI::IsMember({"a4", "letter"}))
        ->capture_default_str();
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = report(*arguments, stop);
                if (!done) {
                    print_error(done.error());
                    return exit_status_of(done.error());
                }
                std::printf("the report is in %s\n", arguments->files.folder.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
