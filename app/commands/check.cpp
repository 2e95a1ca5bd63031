// covaria check FILE: the requirements of a project as test cases, for build servers.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <pugixml.hpp>
#include <sstream>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/printable.h"
#include "core/made/applicability.h"
#include "core/project/release.h"
#include "core/project/stated_requirements.h"
#include "core/report/stated_uncertainty.h"
#include "core/text/numbers.h"
#include "core/views/decisions.h"
#include "core/views/seen_table.h"

namespace covaria {
namespace {

struct CheckArguments {
    RunRequest request;
    std::string junit;
    std::optional<double> level;  ///< for tests of stated figures against residuals; empty: not asked
    bool released = false;        ///< whether a draft is not met
};

/// One requirement on one output, judged.
struct TestCase {
    std::string name;     ///< "pose 7: x, target uncertainty"
    std::string failure;  ///< empty: met
};

struct TestSuite {
    std::string analysis;
    std::vector<TestCase> cases;
    std::string error;  ///< why there is no result; empty if there is one
};

std::string quantity_text(const OutputQuantity& quantity, double si) {
    const std::string unit = quantity.unit.text() == "1" ? "" : " " + quantity.unit.text();
    return format_significant(quantity.unit.interval_from_si(si), 6) + unit;
}

TestCase target_case(const std::string& name, const OutputResult& output, const RequirementResult& verdict) {
    TestCase made{name + ", target uncertainty", verdict.not_judged.english()};
    if (made.failure.empty() && !verdict.meets_target)
        made.failure = "U = " + quantity_text(output.quantity, output.expanded_uncertainty) +
                       " is above its target " + quantity_text(output.quantity, *verdict.target_uncertainty);
    return made;
}

TestCase tolerance_case(const std::string& name, const RequirementResult& verdict) {
    TestCase made{name + ", tolerance", verdict.not_judged.english()};
    if (made.failure.empty() && verdict.decision != RequirementResult::Decision::accept)
        made.failure = "rejected by " + decision_rule(verdict) + "; probability of conformance " +
                       format_significant(verdict.conformance, 4);
    return made;
}

/// A stated figure that the residuals contradict is a failure.
TestCase seen_case(const evidence::StatedFigure& figure, const evidence::SeenFigure& seen) {
    TestCase made{"seen, " + figure.name.english(), {}};
    if (evidence::is_contradicted(seen))
        made.failure = verdict_words(seen.verdict).english() + ": " + format_significant(seen.factor, 3) +
                       " (" + format_significant(seen.low, 3) + " to " + format_significant(seen.high, 3) +
                       ") times what is stated";
    return made;
}

/// Whatever is not known to be applicable is not met.
TestCase certificate_case(const CertificateUse& use) {
    TestCase made{use.holder + ", " + name_of(use.certificate).english(), {}};
    if (use.verdict.verdict == Applicability::applicable) return made;
    made.failure = words_of(use.verdict.verdict).english();
    for (const Message& reason : use.verdict.reasons) made.failure += "; " + reason.english();
    return made;
}

/// What the data do not decide is not shown to be met.
TestCase decision_case(const DecidedRow& decision) {
    TestCase made{to_unicode(decision.subject), {}};
    if (decision.verdict.is != TestVerdict::Is::met)
        made.failure = decision.verdict.words.english() + "; " + to_unicode(decision.figures);
    return made;
}

TestSuite suite_of(const EvaluatedAnalysis& evaluated, const MadeProject& made, std::optional<double> level) {
    const Project& project = made.project();
    TestSuite suite{evaluated.analysis->id, {}, {}};
    const auto redundant =
        level && evaluated.analysis->model ? evaluated.analysis->model->redundant_readings() : nullptr;
    const evidence::Seen seen = redundant ? evidence::see(*redundant, *level) : evidence::Seen();
    for (std::size_t k = 0; k < seen.figures.size(); ++k)
        suite.cases.push_back(seen_case(redundant->figures[k], seen.figures[k]));
    if (evaluated.analysis->descriptor->decides)
        for (const DecidedRow& decision : decisions_in(evaluated.analysis->model->evaluation()))
            suite.cases.push_back(decision_case(decision));
    for (const RequirementResult& verdict :
         judge(*evaluated.result, *project.find_analysis(suite.analysis))) {
        const OutputResult& output = evaluated.result->outputs[verdict.output];
        const std::string& group = output.quantity.group;
        const std::string name = (group.empty() ? "" : group + ": ") + output.quantity.symbol;
        if (verdict.target_uncertainty) suite.cases.push_back(target_case(name, output, verdict));
        if (verdict.lower_limit || verdict.upper_limit) suite.cases.push_back(tolerance_case(name, verdict));
    }
    for (const CapabilityFinding& finding : capability_findings(made, *evaluated.result))
        if (finding.verdict != CapabilityVerdict::raised)
            suite.cases.push_back({"best capability", finding.words.english()});
    for (const CertificateUse& use : figures_used(made, suite.analysis).certificates)
        suite.cases.push_back(certificate_case(use));
    return suite;
}

/// The release of the project: met where it is what was released.
TestSuite suite_of_release(const Project& project) {
    const ReleaseStatus status = release_status(project);
    const std::string words = words_of(status, project.review).english();
    return {"project", {{"release", status.state == ReleaseState::released ? "" : words}}, {}};
}

std::size_t failures_of(const TestSuite& suite) {
    std::size_t count = 0;
    for (const TestCase& one : suite.cases) count += !one.failure.empty();
    return count;
}

void add_suite(pugi::xml_node root, const TestSuite& suite) {
    pugi::xml_node node = root.append_child("testsuite");
    node.append_attribute("name") = suite.analysis.c_str();
    node.append_attribute("tests") = suite.cases.size() + (suite.error.empty() ? 0u : 1u);
    node.append_attribute("failures") = failures_of(suite);
    node.append_attribute("errors") = suite.error.empty() ? 0 : 1;
    const auto add_case = [&](const std::string& name, const char* kind, const std::string& message) {
        pugi::xml_node child = node.append_child("testcase");
        child.append_attribute("classname") = suite.analysis.c_str();
        child.append_attribute("name") = name.c_str();
        if (!message.empty()) child.append_child(kind).append_attribute("message") = message.c_str();
    };
    for (const TestCase& one : suite.cases) add_case(one.name, "failure", one.failure);
    if (!suite.error.empty()) add_case("evaluation", "error", suite.error);
}

/// The format that build servers read (JUnit's); no clock in it, so equal runs give equal bytes.
std::string junit_text(const std::string& file, const std::vector<TestSuite>& suites) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node root = document.append_child("testsuites");
    root.append_attribute("name") = file.c_str();
    for (const TestSuite& suite : suites) add_suite(root, suite);
    std::ostringstream out;
    // XML has no place for control characters, in whatever words.
    document.save(out, "  ", pugi::format_indent | pugi::format_skip_control_chars);
    return printable(out.str());
}

/// Says every case; whether all are met.
bool print_cases(const std::vector<TestSuite>& suites) {
    std::size_t cases = 0, failed = 0;
    for (const TestSuite& suite : suites)
        for (const TestCase& one : suite.cases) {
            ++cases;
            failed += !one.failure.empty();
            std::printf("%s %s/%s%s%s\n", one.failure.empty() ? "met    " : "NOT MET", suite.analysis.c_str(),
                        one.name.c_str(), one.failure.empty() ? "" : ": ", one.failure.c_str());
        }
    std::printf("%zu requirements, %zu not met\n", cases, failed);
    return failed == 0;
}

Result<bool> check(const CheckArguments& arguments, const std::stop_token& stop) {
    auto opened = open_project(arguments.request.file, arguments.request.values, arguments.request.analyses);
    if (!opened) return fail(opened.error());
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    std::vector<TestSuite> suites;
    for (const EvaluatedAnalysis& one : evaluation->analyses)
        suites.push_back(suite_of(one, *evaluation->made, arguments.level));
    const Project& project = (*opened)->project();
    if (arguments.released) suites.push_back(suite_of_release(project));
    for (const FailedAnalysis& failed : evaluation->failed)
        suites.push_back({failed.id, {}, failed.cause.english()});
    if (!arguments.junit.empty())
        if (auto written = write_file_atomically(arguments.junit, junit_text(arguments.request.file, suites));
            !written)
            return fail(written.error());
    const bool met = print_cases(suites);
    if (const ReleaseStatus status = release_status(project); status.state != ReleaseState::unreviewed)
        std::printf("the project: %s\n", words_of(status, project.review).english().c_str());
    if (auto complete = check_complete(*evaluation); !complete) return fail(complete.error());
    return met;
}

}  // namespace

Command check_command(CLI::App& app) {
    auto arguments = std::make_shared<CheckArguments>();
    arguments->request.studies = false;
    CLI::App* command = app.add_subcommand("check",
                                           "Evaluate a project and judge its requirements, the "
                                           "decisions of its test sheets and the "
                                           "certificates of its figures; status 3 if one is "
                                           "not met");
    add_examples(*command, {{"check projects/conformity-micrometer.covaria", "every requirement, one a line"},
                            {"check projects/conformity-micrometer.covaria --junit requirements.xml",
                             "as test cases for a build server"},
                            {"check order.covaria --released", "a draft is not met, too"},
                            {"check projects/er10l-c10.covaria --first-order --seen 0.05",
                             "whether residuals contradict what is stated, too"}});
    add_run_options(*command, arguments->request);
    command
        ->add_option("--seen", arguments->level,
                     "hold stated uncertainties against residuals too, at this level (0.05)")
        ->type_name("LEVEL")
        ->check(CLI::Range(1e-6, 0.5));
    command->add_flag("--released", arguments->released,
                      "the project must be released, and be what was released");
    command->add_option("--junit", arguments->junit, "write the requirements as test cases (JUnit XML)")
        ->type_name("FILE");
    return {command, [arguments](const std::stop_token& stop) {
                const auto met = check(*arguments, stop);
                if (!met) {
                    print_error(met.error());
                    return exit_status_of(met.error());
                }
                return int(*met ? exit_success : exit_not_met);
            }};
}

}  // namespace covaria
