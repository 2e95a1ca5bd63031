// covaria report FILE: evaluates a project and writes its report.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/report_files.h"
#include "app/terminal.h"
#include "ui/theme/document_language.h"

namespace covaria {
namespace {

struct ReportArguments {
    RunRequest request;
    ReportFiles files;
    std::string output;  ///< one file instead
    std::string before;  ///< project to compare with
    bool certificate = false, sheet = false, annex = false;
    std::vector<std::string> without = {};  ///< chapters
};

ReportFiles files_of(const ReportArguments& arguments) {
    ReportFiles files = arguments.files;
    if (arguments.certificate) files.name = "certificate";
    if (arguments.sheet) files.name = "sheet";
    return files;
}

/// Chosen analyses are shown whatever the project leaves out.
ReportDocument document_of(const ReportArguments& arguments, const ReportSource& source) {
    const bool chosen = !arguments.request.analyses.empty();
    const DocumentLanguage in = ui::document_language(source.made.project());
    if (arguments.certificate)
        return build_document(DocumentKind::certificate, source.made, source.analyses, source.failed, chosen,
                              in);
    ReportContents contents = source.made.project().report;
    if (chosen) contents.without_analyses.clear();
    for (const std::string& key : arguments.without) choose(contents.without_chapters, key, false);
    contents.annex = contents.annex || arguments.annex;
    if (arguments.sheet) return build_sheet(source.made, source.analyses, source.failed, contents, in);
    return build_report(source.made, source.analyses, source.failed, contents, in);
}

/// Leaves out analyses that the report does not show: they need not be evaluated.
Result<RunRequest> request_for(const ReportArguments& arguments, const Project& project) {
    RunRequest request = arguments.request;
    if (!request.analyses.empty() || project.report.without_analyses.empty()) return request;
    request.analyses = reported_analyses(project);
    if (request.analyses.empty())
        return fail(ErrorCode::bad_input,
                    "the project leaves every analysis out of its report; name those to show by --analysis",
                    "/report/withoutAnalyses");
    return request;
}

Result<void> report(const ReportArguments& arguments, const std::stop_token& stop) {
    ReportFiles files = files_of(arguments);
    if (!arguments.output.empty())
        if (auto named = write_into_one_file(arguments.output, files); !named) return named;
    if (auto made = make_output_folder(files.folder); !made) return made;
    auto opened = open_project(arguments.request.file, arguments.request.values, arguments.request.analyses);
    if (!opened) return fail(opened.error());
    const auto request = request_for(arguments, (**opened).project());
    if (!request) return fail(request.error());
    auto evaluation = evaluate_analyses(*opened, *request, stop);
    if (!evaluation) return fail(evaluation.error());
    if (!arguments.before.empty())
        if (auto compared = compare_with(arguments.before, arguments.request, *evaluation, stop); !compared)
            return compared;
    const ReportSource source{*evaluation->made, evaluation->analyses, evaluation->failed};
    if (arguments.certificate) say_what_is_missing(source);
    if (auto written = write_document(document_of(arguments, source), source, files, stop); !written)
        return written;
    return check_complete(*evaluation);
}

}  // namespace

Command report_command(CLI::App& app) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command =
        app.add_subcommand("report", "Evaluate a project; write its report as PDF, HTML and Markdown");
    add_examples(*command,
                 {{"report projects/gum/h1-end-gauge.covaria -o report.pdf"},
                  {"report projects/certificate-gauge-block.covaria --certificate -o certificate.pdf"},
                  {"report projects/gum/h1-end-gauge.covaria --trials 1e5 --format html --without evaluation "
                   "--out report",
                   "one format, shorter"}});
    add_run_options(*command, arguments->request);
    command->add_flag("--designs", arguments->request.designs, "search the designs too, for their chapter");
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
    auto* before = command
                       ->add_option("--before", arguments->before,
                                    "project file: its results beside these, as a chapter (see compare)")
                       ->type_name("FILE");
    command
        ->add_flag("--certificate", arguments->certificate,
                   "a calibration certificate of one to three pages instead of the report: the project's "
                   "section \"certificate\" and the results (of the analyses chosen by --analysis)")
        ->excludes(before);
    command
        ->add_flag("--sheet", arguments->sheet,
                   "two pages for each analysis instead of the report: the decisions of its tests, or its "
                   "results and budget, then what there is room for")
        ->excludes(before)
        ->excludes("--certificate");
    std::vector<std::string> chapters;
    for (const ReportChapterField& chapter : report_chapters()) chapters.push_back(chapter.key);
    command->add_option("--without", arguments->without, "a chapter to leave out (may be repeated)")
        ->type_name("CHAPTER")
        ->check(CLI::IsMember(chapters))
        ->allow_extra_args(false);
    command->add_flag("--annex", arguments->annex,
                      "long tables whole at the end too; without it the CSV files of 'run' have them");
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
                    "the %s is in %s\n",
                    arguments->certificate ? "certificate"
                    : arguments->sheet     ? "sheet"
                                           : "report",
                    arguments->output.empty() ? arguments->files.folder.c_str() : arguments->output.c_str());
                return int(exit_success);
            }};
}

}  // namespace covaria
