#include "app/run_outputs.h"

#include <CLI/CLI.hpp>

#include "app/pictures.h"
#include "app/report_files.h"
#include "app/terminal.h"
#include "core/report/report.h"
#include "core/result/representation.h"
#include "core/result_files/result_files.h"
#include "core/result_files/results_json.h"
#include "ui/theme/document_language.h"

namespace covaria {
namespace {

void say_what_does_not_represent(const Project& project, const std::vector<EvaluatedAnalysis>& analyses) {
    for (const EvaluatedAnalysis& one : analyses) {
        if (represents_measurand(*one.result)) continue;
        const AnalysisEntry* entry = project.find_analysis(one.analysis->id);
        const bool required = entry && !entry->requirements.empty();
        print_message("the result of " + one.analysis->id + " " + does_not_represent +
                      (required ? "; its requirements are not judged" : ""));
    }
}

Result<void> write_documents(const RunOutputs& outputs, const ReportSource& source, bool chosen,
                             const std::stop_token& stop) {
    const auto write = [&](DocumentKind kind, const char* name) {
        ReportFiles files{outputs.folder};
        files.name = name;
        files.formats = outputs.formats;
        return write_document(build_document(kind, source.made, source.analyses, source.failed, chosen,
                                             ui::document_language(source.made.project())),
                              source, files, stop);
    };
    if (outputs.report)
        if (auto written = write(DocumentKind::report, "report"); !written) return written;
    if (!outputs.certificate) return {};
    say_what_is_missing(source);
    return write(DocumentKind::certificate, "certificate");
}

}  // namespace

void add_output_options(CLI::App& command, RunOutputs& outputs) {
    command.add_option("--out", outputs.folder, "folder for the results")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--report", outputs.report, "write the report too (PDF, HTML, Markdown)");
    command.add_flag("--certificate", outputs.certificate,
                     "write a calibration certificate too (PDF, HTML, Markdown): the project's section "
                     "\"certificate\" and the results");
    command
        .add_option("--format", outputs.formats,
                    "of report and certificate: pdf, html or markdown (may be repeated; all without it)")
        ->type_name("FORMAT")
        ->check(CLI::IsMember({"pdf", "html", "markdown"}))
        ->allow_extra_args(false);
    command.add_flag("--pictures", outputs.pictures, "write pictures of every analysis too (PNG)");
}

Result<void> write_run_outputs(const RunOutputs& outputs, const MadeProject& opened,
                               const Evaluation& evaluation, bool chosen, const std::stop_token& stop) {
    const std::vector<EvaluatedAnalysis>& analyses = evaluation.analyses;
    say_what_does_not_represent(opened.project(), analyses);
    ResultListing listing{evaluation.failed, {}};
    std::vector<PlannedPicture> pictures;
    if (outputs.pictures) pictures = planned_pictures(analyses);
    for (const PlannedPicture& picture : pictures) listing.files.push_back(listed(picture, analyses));
    if (auto written = write_result_files(outputs.folder, *evaluation.made, analyses, std::move(listing));
        !written)
        return written;
    if (auto written = write_pictures(outputs.folder, analyses, pictures, *evaluation.made, stop); !written)
        return written;
    return write_documents(outputs, {*evaluation.made, analyses, evaluation.failed}, chosen, stop);
}

}  // namespace covaria
