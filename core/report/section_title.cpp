// The title block: the analyses that were evaluated, and the expanded uncertainties at a glance.
#include <algorithm>

#include "core/project/stated_requirements.h"
#include "core/report/date_words.h"
#include "core/report/report_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/decisions.h"

namespace covaria::report_parts {
namespace {

Message method_text(const UncertaintyResult& result, const DocumentLanguage& in) {
    if (result.trials == 0) return tell<"law of propagation of uncertainty">();
    const std::string trials = count_text(result.trials, in.numbers());
    return result.adaptive ? tell<"adaptive Monte Carlo, %1 trials">(trials)
                           : tell<"Monte Carlo, %1 trials">(trials);
}

Message analysis_text(const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    return tell<"%1; %2; coverage probability %3">(Message::declared(evaluated.analysis->descriptor->title),
                                                   method_text(result, in),
                                                   percent_text(result.coverage_probability, in.numbers()));
}

std::string factor_text(const UncertaintyResult& result, const DocumentLanguage& in) {
    const std::string p = percent_text(result.coverage_probability, in.numbers());
    return in.say(tell<"Coverage probability %1.">(p)) + " " + in.say(expanded_words(result)) + " " +
           in.say(tell<"k, intervals and the law of propagation are in the results of the analysis.">());
}

Message not_evaluated(const FailedAnalysis& failed) {
    const std::string name = failed.name.empty() ? failed.id : failed.name;
    return failed.study.empty()
               ? tell<"Not evaluated: %1: %2.">(name, failed.cause)
               : tell<"Study \"%1\" not evaluated: %2: %3.">(failed.study, name, failed.cause);
}

/// The words on how many requirements are met; empty where nothing is required of the results.
Message requirements_met(const EvaluatedAnalysis& evaluated, const Project& project) {
    const std::vector<RequirementResult> verdicts = judge(*evaluated.result, project, evaluated.analysis->id);
    if (verdicts.empty()) return {};
    const auto met = static_cast<std::size_t>(std::count_if(verdicts.begin(), verdicts.end(), is_met));
    return met == verdicts.size() ? tell<"all %1 met">(met)
                                  : tell<"%1 of %2 not met">(verdicts.size() - met, verdicts.size());
}

/// The words on the decisions of a sheet of tests; empty where it decides nothing.
Message decisions_met(const EvaluatedAnalysis& evaluated) {
    if (!evaluated.analysis->descriptor->decides || !evaluated.analysis->model) return {};
    const std::vector<DecidedRow> rows = decisions_in(evaluated.analysis->model->evaluation());
    if (rows.empty()) return {};
    const std::size_t failed = count_of(rows, TestVerdict::Is::not_met),
                      open = count_of(rows, TestVerdict::Is::open);
    if (failed == 0 && open == 0) return tell<"all %1 met">(rows.size());
    if (open == 0) return tell<"%1 of %2 not met">(failed, rows.size());
    if (failed == 0) return tell<"%1 of %2 not decided">(open, rows.size());
    return tell<"%1 of %2 not met, %3 not decided">(failed, rows.size(), open);
}

void add_glance(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    const std::string& name = evaluated.analysis->name;
    if (auto matrix = summary_matrix(result, tell<"Expanded uncertainty U: %1">(name), in)) {
        matrix->table.id = "summary-" + evaluated.analysis->id;
        matrix->table.notes.push_back(factor_text(result, in));
        blocks.push_back(std::move(*matrix));
        return;
    }
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i])) outputs.push_back(i);
    TableBlock block = results_block(result, outputs, tell<"Results: %1">(name), in, false);
    block.table.id = "summary-" + evaluated.analysis->id;
    blocks.push_back(std::move(block));
}

}  // namespace

void add_title(Blocks& blocks, const ReportSource& source) {
    add_facts(blocks, source);
    for (const EvaluatedAnalysis& evaluated : source.analyses) add_glance(blocks, evaluated, source.in);
}

void add_facts(Blocks& blocks, const ReportSource& source) {
    const DocumentLanguage& in = source.in;
    FactsBlock facts;
    const Project& project = source.made.project();
    const auto add = [&](const Message& name, const std::string& text) {
        facts.facts.emplace_back(in.say(name), text);
    };
    if (!project.number.empty()) add(tell<"Number">(), project.number);
    if (!project.author.empty()) add(tell<"Author">(), project.author);
    if (!project.certificate.issued.empty())
        add(tell<"Date of issue">(), date_words(project.certificate.issued, in));
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        add(evaluated.analysis->name, in.say(analysis_text(evaluated, in)));
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        if (const Message met = requirements_met(evaluated, project); !met.empty())
            add(source.analyses.size() == 1 ? tell<"Requirements">()
                                            : tell<"Requirements: %1">(evaluated.analysis->name),
                in.say(met));
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        if (const Message decided = decisions_met(evaluated); !decided.empty())
            add(source.analyses.size() == 1 ? tell<"Decisions">()
                                            : tell<"Decisions: %1">(evaluated.analysis->name),
                in.say(decided));
    if (!source.analyses.empty())
        add(tell<"Evaluated with">(),
            "Covaria " + source.analyses.front().result->provenance.covaria_version);
    std::string missing;
    for (const AnalysisEntry& entry : source.made.project().analyses) {
        const bool there = std::any_of(source.analyses.begin(), source.analyses.end(),
                                       [&](const auto& one) { return one.analysis->id == entry.id; });
        if (!there) missing += (missing.empty() ? "" : ", ") + entry.name;
    }
    if (!missing.empty()) add(tell<"Not in this report">(), missing);
    add(tell<"Project fingerprint">(), project_fingerprint(source));
    add_review(facts, project, in);
    blocks.push_back(std::move(facts));
    add_paragraphs(blocks, source.made.project().notes);
    for (const FailedAnalysis& failed : source.failed)
        blocks.push_back(ParagraphBlock{in.say(not_evaluated(failed)), true});
}

}  // namespace covaria::report_parts
