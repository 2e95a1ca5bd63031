// covaria verify-report FILE.pdf: evaluates the project that a report carries; are its results the same bits?
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/base/version.h"
#include "core/carried/carried_check.h"
#include "core/carried/carried_project.h"
#include "core/carried/report_data.h"
#include "core/project/release.h"
#include "core/readers/entry_texts.h"

namespace covaria {
namespace {

struct ReportToVerify {
    std::string file;
    int threads = 0;
};

void say_other_version(const CarriedResults& carried) {
    if (carried.version == version()) return;
    print_message("the report was made by Covaria " +
                  (carried.version.empty() ? "of an unknown version" : plain_name(carried.version)) +
                  "; this is Covaria " + version() + ", which may compute other bits");
}

std::string words_of(const Comparison& comparison) {
    std::string words;
    for (const std::string& difference : comparison.differences) words += difference + "\n";
    if (comparison.beyond > 0) words += "and " + std::to_string(comparison.beyond) + " others\n";
    return words;
}

/// A report may be without studies, or without some.
void leave_out_studies(Evaluation& evaluation, const CarriedResults& carried) {
    for (EvaluatedAnalysis& one : evaluation.analyses)
        std::erase_if(one.studies, [&](const std::shared_ptr<const StudyResult>& study) {
            return !carried.studies.contains({one.analysis->id, study->id});
        });
    std::erase_if(evaluation.failed, [&](const FailedAnalysis& failed) {
        return !failed.study.empty() && !carried.studies.contains({failed.id, failed.study});
    });
}

/// The outcome of evaluating a report's project again.
enum class Verdict { same, different, not_as_released };

/// Says when the project of the report was released, and what of it is no longer as it was then.
ReleaseState say_release(const std::string& report, const Project& project) {
    const ReleaseStatus status = release_status(project);
    if (status.state != ReleaseState::unreviewed)
        std::printf("%s: its project: %s\n", report.c_str(),
                    words_of(status, project.review).english().c_str());
    return status.state;
}

/// Says what differs.
Result<Verdict> verify_report(const ReportToVerify& report, const std::stop_token& stop) {
    const auto files = carried_files(report.file);
    if (!files) return fail(files.error());
    const auto carried = carried_results(*files);
    if (!carried) return fail(ErrorCode::bad_input, report.file + ": " + carried.error().message);
    const LoadedProject loaded = load_carried(report.file, *files);
    print_problems(loaded.problems);
    say_other_version(*carried);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::bad_input, report.file + ": its project has errors; nothing was computed");
    RunRequest request{.file = report.file,
                       .analyses = carried->analyses,
                       .studies = !carried->studies.empty(),
                       .threads = report.threads};
    if (carried->analyses.empty())
        return fail(ErrorCode::bad_input, report.file + ": it carries no results of analyses");
    auto evaluation = evaluate_analyses(loaded.made, request, stop);
    if (!evaluation) return fail(evaluation.error());
    leave_out_studies(*evaluation, *carried);
    const Comparison comparison =
        compare_carried(*files, report_data({*evaluation->made, evaluation->analyses, evaluation->failed}));
    if (!comparison.same()) {
        std::printf("%s%s: not the same bits\n", words_of(comparison).c_str(), report.file.c_str());
        say_release(report.file, loaded.project);
        return Verdict::different;
    }
    std::printf("%s: same bits: the results of %zu %s\n", report.file.c_str(), carried->analyses.size(),
                carried->analyses.size() == 1 ? "analysis" : "analyses");
    return say_release(report.file, loaded.project) == ReleaseState::changed ? Verdict::not_as_released
                                                                             : Verdict::same;
}

}  // namespace

Command verify_report_command(CLI::App& app) {
    auto report = std::make_shared<ReportToVerify>();
    CLI::App* command = app.add_subcommand(
        "verify-report", "Evaluate the project that a report (PDF) carries; compare with its results");
    add_examples(
        *command, {{"verify-report report.pdf"}},
        "A report of covaria report or of the window carries its project, the CSV files of it, and its "
        "results.\n"
        "Exit status 0: they are computed again to the same bits; 1: what differs is listed, or it could not "
        "be read;\n"
        "3: the same bits, but its project was released once and is no longer what was released.");
    command->add_option("FILE", report->file, "report (*.pdf)")->required();
    add_threads_option(*command, report->threads);
    return {command, [report](const std::stop_token& stop) -> int {
                const auto verdict = verify_report(*report, stop);
                if (!verdict) {
                    print_error(verdict.error());
                    return exit_status_of(verdict.error());
                }
                return *verdict == Verdict::same        ? exit_success
                       : *verdict == Verdict::different ? exit_bad_input
                                                        : exit_not_met;
            }};
}

}  // namespace covaria
