// Notes (warnings and limits of the runs) and provenance. What the models' and assets' descriptions say is on
// their pages.
#include <algorithm>
#include <cstdio>
#include <string>

#include "core/report/report_parts.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

void add_once(std::vector<Message>& list, const std::vector<Message>& more) {
    for (const Message& text : more)
        if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

void add_list(Blocks& blocks, const std::string& heading, std::vector<std::string> items) {
    if (items.empty()) return;
    blocks.push_back(HeadingBlock{2, heading});
    blocks.push_back(ListBlock{std::move(items)});
}

std::string reduction_note(const UncertaintyResult& result) {
    const bool sobol = result.variance_reduction == VarianceReduction::sobol;
    std::string note = sobol ? "The trials are Sobol points with a random digital shift in each batch; "
                               "standard errors are from the "
                               "scatter of the batches."
                             : "Mean, standard uncertainty, symmetric interval and covariance were found "
                               "with the linear part of each "
                               "output as control variate: its distribution is known exactly, and the trials "
                               "tell how the output "
                               "differs from it. Shortest intervals, histograms and probabilities of "
                               "conformance are those of the "
                               "trials.";
    if (const auto gain = least_gain(result)) {
        char text[120];
        std::snprintf(text, sizeof text, " At the interval ends each trial is worth %.2g plain ones or more.",
                      *gain);
        note += text;
    }
    return note;
}

std::vector<Message> run_notes(const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    std::vector<Message> notes = evaluated.warnings;
    add_once(notes, result.warnings);
    if (!result.stabilised)
        notes.push_back(
            "The adaptive procedure reached its largest number of trials: the results have not "
            "stabilised to the numerical tolerance.");
    if (!result.intervals_exact)
        notes.push_back(
            "Coverage intervals were read from finely divided cells, not from ordered trials: there were "
            "more trials than memory allows to order.");
    if (result.variance_reduction != VarianceReduction::none) notes.push_back(reduction_note(result));
    return notes;
}

}  // namespace

void add_notes(Blocks& blocks, const ReportSource& source) {
    Blocks parts;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        std::vector<std::string> notes;
        for (const Message& note : run_notes(evaluated)) notes.push_back(note.english());
        add_list(parts, evaluated.analysis->name, std::move(notes));
    }
    if (parts.empty()) return;
    blocks.push_back(HeadingBlock{1, "Notes"});
    blocks.insert(blocks.end(), parts.begin(), parts.end());
}

std::string project_fingerprint(const ReportSource& source) {
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        if (!evaluated.result->provenance.project_fingerprint.empty())
            return evaluated.result->provenance.project_fingerprint;
    return "–";
}

void add_provenance(Blocks& blocks, const ReportSource& source) {
    blocks.push_back(HeadingBlock{1, "Provenance"});
    TableBuilder table("provenance", "Runs that gave these results");
    table.text("Analysis");
    table.text("Model");
    table.text("Method");
    table.text("Trials");
    table.text("Failed");
    table.text("Seed");
    table.text("Fingerprint");
    table.text("Covaria");
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const UncertaintyResult& result = *evaluated.result;
        std::string method = result.trials == 0 ? "law of propagation"
                             : result.adaptive  ? "adaptive"
                                                : "Monte Carlo";
        if (result.variance_reduction != VarianceReduction::none)
            method += result.variance_reduction == VarianceReduction::sobol ? ", Sobol points"
                                                                            : ", control variate";
        table.row({evaluated.analysis->name, evaluated.analysis->descriptor->id, method,
                   count_text(result.trials), count_text(result.failed_trials),
                   std::to_string(result.provenance.seed), evaluated.analysis->fingerprint(),
                   result.provenance.covaria_version});
    }
    table.note(
        "The same project, seed and version give the same numbers on any number of threads. The fingerprint "
        "covers everything that influences the numbers of an analysis.");
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
