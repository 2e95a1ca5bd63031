// The command covaria impact --replace OLD NEW FOLDER..., which tells the results that change when the
// figures of a certificate do.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/report_files.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/impact/impact_document.h"
#include "core/result_files/csv_writer.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

struct ImpactArguments {
    std::vector<std::string> replaced;  ///< the arguments OLD and NEW
    std::string used;                   ///< the argument OLD alone
    std::vector<std::string> folders;
    std::string csv, output, amend;
    RunRequest method;
};

constexpr std::size_t most_printed_rows = 40;

Result<void> check_arguments(const ImpactArguments& arguments) {
    if (arguments.replaced.empty() == arguments.used.empty())
        return fail(
            ErrorCode::usage,
            "say what is replaced by what (--replace OLD NEW), or whose users are asked for (--used OLD)");
    const RunRequest& method = arguments.method;
    const bool evaluates =
        method.trials || method.adaptive || method.first_order || method.seed || method.variance_reduction;
    if (!arguments.used.empty() &&
        (evaluates || !arguments.csv.empty() || !arguments.output.empty() || !arguments.amend.empty()))
        return fail(ErrorCode::usage,
                    "--used evaluates nothing: there are no changes to write (--csv, -o, --amend) and no "
                    "method to choose; name the new figures, --replace OLD NEW");
    ReportFiles named;
    return arguments.output.empty() ? Result<void>{} : write_into_one_file(arguments.output, named);
}

std::string unit_behind(const Unit& unit) {
    return unit.text() == "1" ? "" : " " + unit.text();
}

ImpactWords words_of(const ImpactArguments& arguments) {
    if (arguments.replaced.empty()) return {arguments.used, {}, arguments.folders};
    return {arguments.replaced[0], arguments.replaced[1], arguments.folders, arguments.method.first_order};
}

const char* word_of(std::optional<bool> met) {
    return !met ? "-" : *met ? "met" : "NOT MET";
}

void print_row(const ImpactRow& row) {
    const Unit& unit = row.quantity.unit;
    const std::string group = row.quantity.group.empty() ? "" : std::string(row.quantity.group) + ": ";
    std::printf("%s: %s/%s%s\n    %s -> %s\n    change %s%s = %s u = %s U; U by %s %%%s\n", row.file.c_str(),
                row.analysis.c_str(), group.c_str(), row.quantity.symbol.c_str(), row.before.stated.c_str(),
                row.after.stated.c_str(), format_significant(unit.interval_from_si(row.change()), 3).c_str(),
                unit_behind(unit).c_str(), format_significant(row.change_in_u(), 3).c_str(),
                format_significant(row.change_in_U(), 3).c_str(),
                format_significant(100.0 * row.change_of_U(), 3).c_str(),
                row.verdict_changes()
                    ? (std::string("; ") + word_of(row.before.met) + " -> " + word_of(row.after.met)).c_str()
                    : "");
}

void print_impact(const Impact& impact, bool users_only) {
    if (users_only)
        for (const std::string& file : impact.using_it) std::printf("%s\n", file.c_str());
    for (std::size_t i = 0; i < std::min(impact.rows.size(), most_printed_rows); ++i)
        print_row(impact.rows[i]);
    if (impact.rows.size() > most_printed_rows)
        std::printf("and %zu results that change less\n", impact.rows.size() - most_printed_rows);
    if (const auto amend = impact.to_amend(); !amend.empty()) {
        std::printf("\nto amend:\n");
        for (const std::string& file : amend) std::printf("  %s\n", file.c_str());
    }
    if (!impact.followers.empty()) std::printf("\nthese follow when those are amended:\n");
    for (const ImpactFollower& one : impact.followers)
        std::printf("  %s\n", follower_words(one).english().c_str());
    for (const ImpactFailure& failure : impact.failures)
        print_message(failure.file + ": not evaluated: " + failure.cause.english());
    std::printf("%s", impact.using_it.empty() ? "" : "\n");
    for (const Message& sentence : impact_sentences(impact)) std::printf("%s\n", sentence.english().c_str());
}

Result<void> write_impact_document(const ImpactArguments& arguments, const Impact& impact,
                                   const std::stop_token& stop) {
    ReportFiles files;
    if (auto named = write_into_one_file(arguments.output, files); !named) return named;
    return write_document(build_impact(words_of(arguments), impact), files, stop);
}

Result<void> write_files(const ImpactArguments& arguments, const Impact& impact,
                         const std::stop_token& stop) {
    if (!arguments.csv.empty())
        if (auto written = write_file_atomically(arguments.csv, to_csv(impact_table(impact))); !written)
            return written;
    if (!arguments.amend.empty())
        if (auto written = write_file_atomically(arguments.amend, file_list(impact.to_amend())); !written)
            return written;
    return arguments.output.empty() ? Result<void>{} : write_impact_document(arguments, impact, stop);
}

/// Shows the impact; returns whether everything could be evaluated.
Result<bool> show_impact(const ImpactArguments& arguments, const std::stop_token& stop) {
    if (auto right = check_arguments(arguments); !right) return fail(right.error());
    auto question = question_of(words_of(arguments));
    if (!question) return fail(question.error());
    question->asked = [&](const MadeProject::Pointer& made) { return requested(made, arguments.method); };
    const auto impact =
        impact_of(*question, {stop, progress_line("impact"), arguments.method.threads, nullptr});
    end_progress_line();
    if (!impact) return fail(impact.error());
    print_impact(*impact, arguments.replaced.empty());
    if (auto written = write_files(arguments, *impact, stop); !written) return fail(written.error());
    return impact->failures.empty();
}

}  // namespace

Command impact_command(CLI::App& app) {
    auto arguments = std::make_shared<ImpactArguments>();
    CLI::App* command = app.add_subcommand(
        "impact", "Which results of which reports and projects change when the figures of a certificate do");
    add_examples(*command,
                 {{"impact --replace 'NI 2025-0933' new.covaria archive --csv impact.csv",
                   "every report and project below archive that used it, evaluated again"},
                  {"impact --replace 'NI 2025-0933' new.covaria#length archive -o impact.pdf",
                   "the new figures are those of one analysis, or asset, of a project"},
                  {"impact --used 'NI 2025-0933' archive", "who used it, without an evaluation"}},
                 "OLD: number of a certificate, its file or the SHA-256 of it; else id or name of an asset.\n"
                 "NEW: a project, a report (PDF) or a file of others with the new figures; FILE#ID is one "
                 "asset or analysis of it.\n"
                 "Exit status 0: all that use it were evaluated; 1: what could not be is named.");
    command->add_option("--replace", arguments->replaced, "the figures of OLD by those of NEW")
        ->type_name("OLD NEW")
        ->expected(2)
        ->allow_extra_args(false);  // what follows is a folder
    command->add_option("--used", arguments->used, "only who used OLD")->type_name("OLD");
    command->add_option("FOLDER", arguments->folders, "folders and files to look through")->required();
    command->add_option("--csv", arguments->csv, "write the table of all results")->type_name("FILE.csv");
    command->add_option("-o,--output", arguments->output, "write it as a document: .pdf, .html or .md")
        ->type_name("FILE");
    command->add_option("--amend", arguments->amend, "write the list of files to amend")->type_name("FILE");
    add_method_options(*command, arguments->method);
    return {command, [arguments](const std::stop_token& stop) -> int {
                const auto complete = show_impact(*arguments, stop);
                if (complete) return *complete ? exit_success : exit_bad_input;
                print_error(complete.error());
                return exit_status_of(complete.error());
            }};
}

}  // namespace covaria
