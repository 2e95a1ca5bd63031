// covaria compare A B: results beside each other, and what of the budgets changed.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/report_files.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/document/document_writers.h"
#include "core/report/comparison_report.h"
#include "core/result_files/csv_writer.h"
#include "ui/theme/document_language.h"

namespace covaria {
namespace {

struct CompareArguments {
    std::string before, after, out;
    std::string output;  ///< one file, as a report is
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
    return {};
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

Result<void> compare(const CompareArguments& arguments, const std::stop_token& stop) {
    if (auto right = check_arguments(arguments); !right) return right;
    const auto before = open_project(arguments.before);
    if (!before) return fail(before.error());
    const auto after =
        open_project(arguments.after.empty() ? arguments.before : arguments.after, arguments.values);
    if (!after) return fail(after.error());
    const auto plan = plan_of(arguments, (*before)->project(), (*after)->project());
    if (!plan) return fail(plan.error());
    std::vector<std::string> old, now;
    for (const AnalysisPair& pair : plan->pairs) {
        old.push_back(pair.before);
        now.push_back(pair.after);
    }
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
                   "a project, and what it would be"}});
    command->add_option("A", arguments->before, "project file (*.covaria): before")->required();
    command->add_option("B", arguments->after,
                        "project file: after; without it two analyses of A, or A with the values of --set");
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
                     "one file too, in the format of its ending: .pdf, .html or .md")
        ->type_name("FILE");
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
