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
    std::string output;  ///< one file instead
    bool certificate = false;
};

ReportFiles files_of(const ReportArguments& arguments) {
    ReportFiles files = arguments.files;
    if (arguments.certificate) files.name = "certificate";
    return files;
}

Result<void> write(const ReportArguments& arguments, const ReportContent& source, const ReportFiles& files,
                   const std::stop_token& stop) {
    if (!arguments.certificate) return write_reports(source, files, stop);
    say_what_is_missing(source.made.project());
    const auto which =
        arguments.request.analyses.empty() ? CertifiedResults::that_fit : CertifiedResults::all;
    return write_certificate(source, which, files, stop);
}

Result<void> report(const ReportArguments& arguments, const std::stop_token& stop) {
    ReportFiles files = files_of(arguments);
    if (!arguments.output.empty())
        if (auto named = write_into_one_file(arguments.output, files); !named) return named;
    if (auto made = make_output_folder(files.folder); !made) return made;
    auto opened = open_project(arguments.request.file, arguments.request.values);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    const ReportContent source{*evaluation->made, evaluation->analyses, evaluation->failed};
    if (auto written = write(arguments, source, files, stop); !written) return written;
    return check_complete(*evaluation);
}

}  // namespace

Command report_command(CLI::App& app) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command =
        app.add_subcommand("report", "Evaluate a project; write its report as PDF, HTML and Markdown");
    add_run_options(*command, arguments->request);
    auto* folder = command->add_option("--out", arguments->files.folder, "folder for the report")
                       ->type_name("DIR")
                       ->capture_default_str();
    auto* formats = command
                        ->add_option("--format", arguments->files.formats,
                                     "pdf, html or markdown (may be repeated; all without it)")
                        ->type_name("FORMAT")
                        ->check(CLI::IsMember({"pdf", "html", "markdown"}));
    command
        ->add_option("-o,--output", arguments->output,
                     "one file instead, in the format of its ending: .pdf, .html or .md")
        ->type_name("FILE")
        ->excludes(folder)
        ->excludes(formats);
    command->add_flag("--certificate", arguments->certificate,
                      "a calibration certificate of one to three pages instead of the report: the project's "
                      "section \"certificate\" and the results (of the analyses chosen by --analysis)");
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
                std::printf(
                    "the %s is in %s\n", arguments->certificate ? "certificate" : "report",
                    arguments->output.empty() ? arguments->files.folder.c_str() : arguments->output.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
