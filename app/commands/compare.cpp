// covaria compare A B: results beside each other, and what of the budgets changed.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/report_files.h"
#include "app/saved_project.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/carried/carried_project.h"
#include "core/document/document_writers.h"
#include "core/report/amendment.h"
#include "core/report/comparison_report.h"
#include "core/result_files/csv_writer.h"
#include "ui/document/today.h"
#include "ui/theme/document_language.h"

namespace covaria {
namespace {

struct CompareArguments {
    std::string before, after, out;
    std::string output;  ///< one file, as a report is
    AmendmentRequest amendment = {};
    std::vector<std::string> analyses, values;
    RunRequest method;
};

/// The analyses that are compared, by their ids.
struct AnalysisPair {
    std::string before, after;
};
struct ComparePlan {
    std::vector<AnalysisPair> pairs;
    std::vector<std::string> only_before, only_after;
};

/// A project, or the one that a report carries; a certificate that was issued is amended by its PDF.
Result<MadeProject::Pointer> open_side(const std::string& file, const std::vector<std::string>& values) {
    const auto bytes = read_file(file);
    if (!bytes || !is_pdf(*bytes)) return open_project(file, values);
    if (!values.empty())
        return fail(ErrorCode::usage, "values are set in a project file, not in a report (PDF)");
    const LoadedProject loaded = load_carried(file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::bad_input, file + ": its project has errors; nothing was computed");
    return loaded.made;
}

Result<void> check_amendment(const CompareArguments& arguments) {
    const AmendmentRequest& asked = arguments.amendment;
    if (asked.number.empty() && asked.reasons.empty() && asked.issued.empty()) return {};
    if (asked.number.empty())
        return fail(ErrorCode::usage,
                    "--reason and --issued are of an amended certificate: give its number, --amend NUMBER");
    if (asked.reasons.empty())
        return fail(ErrorCode::usage, "an amended certificate states its reasons: --reason TEXT");
    if (arguments.output.empty())
        return fail(ErrorCode::usage,
                    "say where the amended certificate goes: -o FILE.pdf, .html or .md, or -o "
                    "FILE.covaria for its project");
    if (!arguments.analyses.empty())
        return fail(ErrorCode::usage, "an amended certificate is compared as a whole: leave out --analysis");
    return {};
}

Result<void> check_arguments(const CompareArguments& arguments) {
    if (arguments.analyses.size() > 2)
        return fail(ErrorCode::usage, "two analyses are compared: --analysis is given once or twice");
    const bool changed = !arguments.after.empty() || !arguments.values.empty();
    if (!changed && arguments.analyses.size() < 2)
        return fail(ErrorCode::usage,
                    "name what to compare with: a second project, two analyses of this one (--analysis A "
                    "--analysis B), or values that are changed (--set PLACE=VALUE)");
    if (!changed && arguments.analyses[0] == arguments.analyses[1])
        return fail(ErrorCode::usage, "an analysis of one project is compared with another one");
    return check_amendment(arguments);
}

std::vector<std::string> analysis_ids(const Project& project) {
    std::vector<std::string> all;
    for (const AnalysisEntry& analysis : project.analyses) all.push_back(analysis.id);
    return all;
}

/// Pairs of analyses: the chosen ones; else those of the same id; else the only ones.
Result<ComparePlan> plan_of(const CompareArguments& arguments, const Project& before, const Project& after) {
    ComparePlan plan;
    if (!arguments.analyses.empty()) {
        plan.pairs.push_back({arguments.analyses.front(), arguments.analyses.back()});
        return plan;
    }
    const std::vector<std::string> old = analysis_ids(before), now = analysis_ids(after);
    for (const std::string& id : old) {
        const bool both = std::find(now.begin(), now.end(), id) != now.end();
        if (both)
            plan.pairs.push_back({id, id});
        else
            plan.only_before.push_back(id);
    }
    for (const std::string& id : now)
        if (std::find(old.begin(), old.end(), id) == old.end()) plan.only_after.push_back(id);
    if (plan.pairs.empty() && old.size() == 1 && now.size() == 1)
        return ComparePlan{{{old[0], now[0]}}, {}, {}};
    if (plan.pairs.empty())
        return fail(
            ErrorCode::not_found,
            "the projects have no analysis of the same id: choose one of each, --analysis A --analysis B");
    return plan;
}

Result<Evaluation> evaluate_side(const MadeProject::Pointer& made, const CompareArguments& arguments,
                                 std::vector<std::string> analyses, const std::stop_token& stop) {
    RunRequest request = arguments.method;
    request.analyses = std::move(analyses);
    request.studies = false;
    return evaluate_analyses(made, request, stop);
}

std::shared_ptr<const UncertaintyResult> result_of(const Evaluation& evaluation, const std::string& id) {
    for (const EvaluatedAnalysis& one : evaluation.analyses)
        if (one.analysis->id == id) return one.result;
    return nullptr;
}

std::string sides_words(const CompareArguments& arguments) {
    std::string words = arguments.after.empty() ? arguments.before : arguments.after;
    for (const std::string& value : arguments.values) words += ", " + value;
    return words;
}

Result<void> write_out(const CompareArguments& arguments, const ReportDocument& document,
                       const std::vector<ComparedAnalysis>& compared) {
    const std::string text = to_markdown(document);
    std::fputs(text.c_str(), stdout);
    if (arguments.out.empty()) return {};
    const std::filesystem::path folder = arguments.out;
    if (auto made = make_output_folder(folder); !made) return made;
    auto written = write_file_atomically(folder / "comparison.md", text);
    for (const ComparedAnalysis& one : compared)
        for (const Table& table : comparison_tables(one))
            if (written) written = write_file_atomically(folder / (table.id + ".csv"), to_csv(table));
    return written;
}

/// Writes the report; it carries the later project and is in its language, as reports are.
Result<void> write_as_report(const std::string& file, const ReportDocument& document, const Evaluation& after,
                             const std::stop_token& stop) {
    ReportFiles files;
    if (auto named = write_into_one_file(file, files); !named) return named;
    if (auto made = make_output_folder(files.folder); !made) return made;
    return write_document(document, {*after.made, after.analyses, after.failed}, files, stop);
}

/// The analyses whose results a certificate of the project states.
std::vector<EvaluatedAnalysis> those_stated(const Evaluation& evaluation) {
    std::vector<EvaluatedAnalysis> stated = evaluation.analyses;
    std::erase_if(stated, [&](const EvaluatedAnalysis& one) {
        return !evaluation.made->project().report.has_analysis(one.analysis->id);
    });
    return stated;
}

/// Writes the amended certificate, or its project where the file's name says so.
Result<void> write_amended(const CompareArguments& arguments, const Evaluation& was,
                           const MadeProject::Pointer& now, const ComparePlan& plan,
                           const std::stop_token& stop) {
    std::map<std::string, std::string> present;
    for (const AnalysisPair& pair : plan.pairs) present.emplace(pair.before, pair.after);
    AmendmentRequest request = arguments.amendment;
    if (request.issued.empty()) request.issued = ui::today();
    const std::vector<EvaluatedAnalysis> stated = those_stated(was);
    auto project = amended(now->project(), was.made->project(),
                           statements_of({*was.made, stated, was.failed}, present), request);
    if (!project) return fail(project.error());
    const std::filesystem::path file = arguments.output;
    if (file.extension() == ".covaria") return save_with_tables(*std::move(project), file);
    ReportFiles files;
    if (auto named = write_into_one_file(arguments.output, files); !named) return named;
    if (auto made = make_output_folder(files.folder); !made) return made;
    auto evaluation = evaluate_side(MadeProject::make(*std::move(project), now), arguments,
                                    reported_analyses(now->project()), stop);
    if (!evaluation) return fail(evaluation.error());
    const ReportSource source{*evaluation->made, evaluation->analyses, evaluation->failed};
    say_what_is_missing(source);
    const ReportDocument document =
        build_document(DocumentKind::certificate, source.made, source.analyses, source.failed, false,
                       ui::document_language(source.made.project()));
    if (auto written = write_document(document, source, files, stop); !written) return written;
    return check_complete(*evaluation);
}

Result<void> compare(const CompareArguments& arguments, const std::stop_token& stop) {
    if (auto right = check_arguments(arguments); !right) return right;
    const auto before = open_side(arguments.before, {});
    if (!before) return fail(before.error());
    const auto after =
        open_side(arguments.after.empty() ? arguments.before : arguments.after, arguments.values);
    if (!after) return fail(after.error());
    const auto plan = plan_of(arguments, (*before)->project(), (*after)->project());
    if (!plan) return fail(plan.error());
    std::vector<std::string> old, now;
    for (const AnalysisPair& pair : plan->pairs) {
        old.push_back(pair.before);
        now.push_back(pair.after);
    }
    const bool amends = !arguments.amendment.number.empty();
    if (amends) old.insert(old.end(), plan->only_before.begin(), plan->only_before.end());
    const auto was = evaluate_side(*before, arguments, old, stop);
    if (!was) return fail(was.error());
    const auto is = evaluate_side(*after, arguments, now, stop);
    if (!is) return fail(is.error());
    std::vector<ComparedAnalysis> compared;
    for (const AnalysisPair& pair : plan->pairs) {
        const auto a = result_of(*was, pair.before), b = result_of(*is, pair.after);
        if (!a || !b) continue;
        const bool same = pair.before == pair.after;
        compared.push_back({file_name_part(same ? pair.before : pair.before + "-" + pair.after),
                            same ? pair.before : pair.before + " (before), " + pair.after + " (after)",
                            compare_results(a, b)});
    }
    const ComparedSides sides{arguments.before, sides_words(arguments), plan->only_before, plan->only_after};
    if (auto written = write_out(arguments, build_comparison(sides, compared), compared); !written)
        return written;
    if (amends) {
        if (auto complete = check_complete(*was); !complete) return complete;
        if (auto complete = check_complete(*is); !complete) return complete;
        return write_amended(arguments, *was, *after, *plan, stop);
    }
    if (!arguments.output.empty()) {
        const ReportDocument document =
            build_comparison(sides, compared, ui::document_language((*after)->project()));
        if (auto written = write_as_report(arguments.output, document, *is, stop); !written) return written;
    }
    if (auto complete = check_complete(*was); !complete) return complete;
    return check_complete(*is);
}

}  // namespace

Command compare_command(CLI::App& app) {
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command = app.add_subcommand(
        "compare", "Put results beside each other: U before and after, and what of the budgets changed");
    add_examples(*command,
                 {{"compare projects/ballbar-tcp.covaria --analysis paper --analysis stated --first-order",
                   "two analyses of one project"},
                  {"compare projects/gum/h1-end-gauge.covaria --analysis table --set "
                   "/analyses/table/setup/quantities/rows/l_S/a=150 --out comparison",
                   "a project, and what it would be"},
                  {"compare issued.pdf corrected.covaria --amend 2026-114-A --reason 'Wrong temperature' -o "
                   "2026-114-A.pdf",
                   "the amended certificate: what it replaces, why, and what has changed"}});
    command->add_option("A", arguments->before, "project file (*.covaria) or report (*.pdf): before")
        ->required();
    command->add_option(
        "B", arguments->after,
        "project file or report: after; without it two analyses of A, or A with the values of --set");
    command
        ->add_option("--analysis", arguments->analyses,
                     "the analysis with this id of both; given twice: the first of A beside the second of B; "
                     "without it all that both have")
        ->type_name("ID")
        ->allow_extra_args(false);
    add_method_options(*command, arguments->method);
    command->add_option("--set", arguments->values, "a value of the project after, as of run")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    command->add_option("--out", arguments->out, "folder for comparison.md and CSV tables with everything")
        ->type_name("DIR");
    command
        ->add_option("-o,--output", arguments->output,
                     "one file too, in the format of its ending: .pdf, .html or .md; the amended "
                     "certificate where one is asked for, or with .covaria its project")
        ->type_name("FILE");
    command
        ->add_option("--amend", arguments->amendment.number,
                     "number of the certificate of B that replaces the one of A (ISO/IEC 17025 7.8.8)")
        ->type_name("NUMBER");
    command->add_option("--reason", arguments->amendment.reasons, "why it is amended")->type_name("TEXT");
    command
        ->add_option("--issued", arguments->amendment.issued,
                     "date of issue of the amended certificate: 2026-04-20; without it today")
        ->type_name("DATE");
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = compare(*arguments, stop);
                if (!done) {
                    print_error(done.error());
                    return exit_status_of(done.error());
                }
                return int(exit_success);
            }};
}

}  // namespace covaria
