// covaria verify: evaluates the shipped cases and holds them against published and reference values.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
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
#include "app/program_facts.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/verification/dossier.h"
#include "ui/export/report_export.h"

namespace covaria {
namespace {

struct VerifyArguments {
    std::string out;
    std::string dossier;
    int threads = 0;
    bool json = false;
    bool figures = false;
    bool first_order = false;
};

/// Evaluates cases; those of one project that follow each other open it once.
class CaseEvaluator {
public:
    CaseEvaluator(const VerifyArguments& arguments, std::stop_token stop)
        : arguments_(arguments), stop_(std::move(stop)) {}

    /// A case that cannot be evaluated says why. Error: stopped.
    Result<CheckedCase> evaluate(VerificationCase verification) {
        if (arguments_.first_order) std::erase_if(verification.checks, needs_trials);
        auto checked = evaluated(verification);
        if (checked || checked.error().code == ErrorCode::cancelled) return checked;
        return CheckedCase{std::move(verification), {}, checked.error().message.english()};
    }

private:
    Result<CheckedCase> evaluated(const VerificationCase& verification) {
        RunRequest request;
        request.file = (data_directory() / verification.project).string();
        request.threads = arguments_.threads;
        request.studies = false;
        request.first_order = arguments_.first_order;
        std::set<std::string> analyses;
        for (const VerificationCheck& check : verification.checks)
            if (analyses.insert(check.analysis).second) request.analyses.push_back(check.analysis);
        if (analyses.empty()) return CheckedCase{verification, {}};
        if (request.file != file_) {
            auto opened = open_project(request.file);
            if (!opened) return fail(opened.error());
            file_ = request.file;
            opened_ = *opened;
        }
        auto evaluation = evaluate_analyses(opened_, request, stop_);
        if (!evaluation) return fail(evaluation.error());
        if (auto complete = check_complete(*evaluation); !complete) return fail(complete.error());
        return check_case(verification, evaluation->analyses);
    }

    const VerifyArguments& arguments_;
    std::stop_token stop_;
    std::string file_;
    MadeProject::Pointer opened_;
};

/// The text of the figures that fail, and their number.
std::string failures_text(const std::vector<CheckedCase>& cases) {
    std::vector<CheckedCase> failing;
    std::size_t figures = 0, failed = 0;
    for (const CheckedCase& one : cases) {
        figures += one.figures.size();
        if (one.passed()) continue;
        failing.push_back(one);
        std::erase_if(failing.back().figures, [](const CheckedFigure& f) { return f.passed(); });
        failed += failing.back().figures.size();
    }
    return (failing.empty() ? std::string() : verification_text(failing)) + std::to_string(failed) + " of " +
           std::to_string(figures) + " figures fail, in " + std::to_string(failing.size()) + " of " +
           std::to_string(cases.size()) + " cases\n";
}

/// FILE.pdf with the figures attached as JSON, and FILE.json beside it.
Result<void> write_dossier(const std::vector<CheckedCase>& cases, const std::string& file,
                           const std::stop_token& stop) {
    const std::filesystem::path pdf = file;
    const auto facts = program_facts();
    if (!facts) return fail(facts.error());
    const auto document = dossier_document(cases, *facts);
    if (!document) return fail(document.error());
    const auto json = dossier_json(cases, *facts);
    if (!json) return fail(json.error());
    std::filesystem::path beside = pdf;
    beside.replace_extension(".json");
    if (auto written = write_file_atomically(beside, *json); !written) return written;
    const auto application = make_application(Platform::offscreen);
    ui::ReportTarget target;
    target.folder = pdf.parent_path();
    target.name = pdf.stem().string();
    target.formats = {ui::ReportFormat::pdf};
    target.attached = {{beside.filename().string(), *json, "application/json",
                        "Every figure of the dossier, for programs", AttachedAs::data}};
    return ui::export_report(*document, target, {}, stop);
}

Result<bool> verify(const VerifyArguments& arguments, const std::stop_token& stop) {
    if (!arguments.out.empty())
        if (auto made = make_output_folder(arguments.out); !made) return fail(made.error());
    const std::filesystem::path dossier = arguments.dossier;
    if (!dossier.empty() && dossier.has_parent_path())
        if (auto made = make_output_folder(dossier.parent_path()); !made) return fail(made.error());
    auto cases = shipped_verification();
    if (!cases) return fail(cases.error());
    CaseEvaluator evaluator(arguments, stop);
    std::vector<CheckedCase> checked;
    bool passed = true;
    for (VerificationCase& verification : *cases) {
        auto one = evaluator.evaluate(std::move(verification));
        if (!one) return fail(one.error());
        passed = passed && one->passed();
        checked.push_back(std::move(*one));
    }
    std::fputs((arguments.json                                    ? verification_json(checked)
                : arguments.figures || !arguments.dossier.empty() ? failures_text(checked)
                                                                  : verification_text(checked))
                   .c_str(),
               stdout);
    if (!arguments.dossier.empty())
        if (auto written = write_dossier(checked, arguments.dossier, stop); !written)
            return fail(written.error());
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
                  {"verify --dossier dossier.pdf",
                   "scope of every model, clauses of the GUM, all cases, versions and digests; dossier.json "
                   "beside it"},
                  {"verify --figures --first-order", "in seconds, only what fails"},
                  {"verify --json", "for programs"}});
    auto* out = command->add_option("--out", arguments->out, "folder for the table as PDF, HTML and Markdown")
                    ->type_name("DIR");
    command
        ->add_option(
            "--dossier", arguments->dossier,
            "PDF/A of the evidence (scope of the models, clauses of the GUM, cases), and JSON beside it")
        ->type_name("FILE.pdf")
        ->check(CLI::Validator(
            [](const std::string& name) {
                return name.ends_with(".pdf") ? std::string() : "the dossier is a PDF: " + name;
            },
            ""))
        ->excludes(out);
    command->add_flag("--figures", arguments->figures, "print only the figures that fail, and how many do");
    command->add_flag("--first-order", arguments->first_order,
                      "only figures by the law of propagation of uncertainty");
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
