// covaria verify: evaluates the shipped cases and holds them against published and reference values.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <set>

#include "app/application.h"
#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/output_folder.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/verification/verification.h"
#include "ui/export/report_export.h"

namespace covaria {
namespace {

struct VerifyArguments {
    std::string out;
    int threads = 0;
    bool json = false;
};

Result<std::vector<VerificationCase>> shipped_cases() {
    const auto text = read_file(data_directory() / "resources" / "verification.json");
    if (!text) return fail(text.error());
    return read_verification(*text);
}

Result<CheckedCase> evaluate_case(const VerificationCase& verification, int threads,
                                  const std::stop_token& stop) {
    RunRequest request;
    request.file = (data_directory() / verification.project).string();
    request.threads = threads;
    request.studies = false;
    std::set<std::string> analyses;
    for (const VerificationCheck& check : verification.checks)
        if (analyses.insert(check.analysis).second) request.analyses.push_back(check.analysis);
    auto opened = open_project(request.file);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, request, stop);
    if (!evaluation) return fail(evaluation.error());
    if (auto complete = check_complete(*evaluation); !complete) return fail(complete.error());
    return check_case(verification, evaluation->analyses);
}

Result<bool> verify(const VerifyArguments& arguments, const std::stop_token& stop) {
    if (!arguments.out.empty())
        if (auto made = make_output_folder(arguments.out); !made) return fail(made.error());
    const auto cases = shipped_cases();
    if (!cases) return fail(cases.error());
    std::vector<CheckedCase> checked;
    bool passed = true;
    for (const VerificationCase& verification : *cases) {
        auto one = evaluate_case(verification, arguments.threads, stop);
        if (!one) return fail(one.error());
        passed = passed && one->passed();
        checked.push_back(std::move(*one));
    }
    std::fputs((arguments.json ? verification_json(checked) : verification_text(checked)).c_str(), stdout);
    if (arguments.out.empty()) return passed;
    const auto application = make_application(Platform::offscreen);
    ui::ReportTarget target;
    target.folder = arguments.out;
    target.name = "verification";
    if (auto written = ui::export_report(verification_report(checked), target, {}, stop); !written)
        return fail(written.error());
    return passed;
}

}  // namespace

Command verify_command(CLI::App& app) {
    auto arguments = std::make_shared<VerifyArguments>();
    CLI::App* command = app.add_subcommand(
        "verify", "Evaluate the shipped cases; compare every figure with published and reference values");
    add_examples(*command,
                 {{"verify"},
                  {"verify --out verification", "the table for a quality manual: PDF, HTML and Markdown"},
                  {"verify --json", "for programs"}});
    command->add_option("--out", arguments->out, "folder for the table as PDF, HTML and Markdown")
        ->type_name("DIR");
    add_threads_option(*command, arguments->threads);
    add_json_option(*command, arguments->json);
    return {command, [arguments](const std::stop_token& stop) {
                const auto passed = verify(*arguments, stop);
                if (passed) return int(*passed ? exit_success : exit_bad_input);
                print_error(passed.error());
                return exit_status_of(passed.error());
            }};
}

}  // namespace covaria
