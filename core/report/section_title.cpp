// Title block: what was evaluated, and the expanded uncertainties at a glance.
#include "core/report/report_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"

#include <algorithm>

namespace covaria::report_parts {
namespace {

std::string method_text(const UncertaintyResult& result) {
    if (result.trials == 0) return "law of propagation of uncertainty";
    const std::string trials = count_text(result.trials) + " trials";
    return (result.adaptive ? "adaptive Monte Carlo, " : "Monte Carlo, ") + trials;
}

std::string analysis_text(const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    return evaluated.analysis->descriptor->title + "; " + method_text(result) + "; coverage probability " +
           percent_text(result.coverage_probability);
}

std::string factor_text(const UncertaintyResult& result) {
    return "Coverage probability " + percent_text(result.coverage_probability) + ". " +
           expanded_words(result) +
           " k, intervals and the law of propagation are in the results of the analysis.";
}

void add_glance(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    const std::string title = "Expanded uncertainty U: " + evaluated.analysis->name;
    if (auto matrix = summary_matrix(result, title)) {
        matrix->table.id = "summary-" + evaluated.analysis->id;
        matrix->table.notes.push_back(factor_text(result));
        blocks.push_back(std::move(*matrix));
        return;
    }
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i])) outputs.push_back(i);
    TableBlock block = results_block(result, outputs, "Results: " + evaluated.analysis->name);
    block.table.id = "summary-" + evaluated.analysis->id;
    blocks.push_back(std::move(block));
}

}  // namespace

void add_title(Blocks& blocks, const ReportSource& source) {
    FactsBlock facts;
    const Project& project = source.made.project();
    if (!project.number.empty()) facts.facts.emplace_back("Number", project.number);
    if (!project.author.empty()) facts.facts.emplace_back("Author", project.author);
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        facts.facts.emplace_back(evaluated.analysis->name, analysis_text(evaluated));
    if (!source.analyses.empty())
        facts.facts.emplace_back("Evaluated with",
                                 "Covaria " + source.analyses.front().result->provenance.covaria_version);
    std::string missing;
    for (const AnalysisEntry& entry : source.made.project().analyses) {
        const bool there = std::any_of(source.analyses.begin(), source.analyses.end(),
                                       [&](const auto& one) { return one.analysis->id == entry.id; });
        if (!there) missing += (missing.empty() ? "" : ", ") + entry.name;
    }
    if (!missing.empty()) facts.facts.emplace_back("Not in this report", missing);
    facts.facts.emplace_back("Project fingerprint", project_fingerprint(source));
    blocks.push_back(std::move(facts));
    add_paragraphs(blocks, source.made.project().notes);
    for (const FailedAnalysis& failed : source.failed)
        blocks.push_back(ParagraphBlock{
            (failed.study.empty() ? "Not evaluated: " : "Study \"" + failed.study + "\" not evaluated: ") +
                (failed.name.empty() ? failed.id : failed.name) + ": " + failed.cause + ".",
            true});
    for (const EvaluatedAnalysis& evaluated : source.analyses) add_glance(blocks, evaluated);
}

}  // namespace covaria::report_parts
