// Notes (warnings and limits of the runs) and provenance. The descriptions of models and assets are on their
// pages.
#include <algorithm>
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

Message reduction_note(const UncertaintyResult& result, const DocumentLanguage& in) {
    Message note =
        result.variance_reduction == VarianceReduction::sobol
            ? tell<
                  "The trials are Sobol points with a random digital shift in each batch; standard errors "
                  "are from the scatter of the batches.">()
            : tell<
                  "Mean, standard uncertainty, symmetric interval and covariance were found with the linear "
                  "part of each output as control variate: its distribution is known exactly, and the "
                  "trials tell how the output differs from it. Shortest intervals, histograms and "
                  "probabilities of conformance are those of the trials.">();
    if (const auto gain = least_gain(result))
        note += " " + tell<"At the interval ends each trial is worth %1 plain ones or more.">(
                          grouped_digits(format_short(*gain, 2), in.numbers()));
    return note;
}

std::vector<Message> run_notes(const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    std::vector<Message> notes = evaluated.warnings;
    add_once(notes, result.warnings);
    if (!result.stabilised)
        notes.push_back(tell<"The adaptive procedure reached its largest number of trials: the results have "
                             "not stabilised to the numerical tolerance.">());
    if (!result.intervals_exact)
        notes.push_back(tell<"Coverage intervals were read from finely divided cells, not from ordered "
                             "trials: there were more trials than memory allows to order.">());
    if (result.variance_reduction != VarianceReduction::none) notes.push_back(reduction_note(result, in));
    return notes;
}

Message method_of(const UncertaintyResult& result) {
    Message method = result.trials == 0 ? tell<"law of propagation">()
                     : result.adaptive  ? tell<"adaptive">()
                                        : tell<"Monte Carlo">();
    switch (result.variance_reduction) {
        case VarianceReduction::none:
            return method;
        case VarianceReduction::sobol:
            return tell<"%1, Sobol points">(std::move(method));
        default:
            return tell<"%1, control variate">(std::move(method));
    }
}

}  // namespace

void add_notes(Blocks& blocks, const ReportSource& source) {
    Blocks parts;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        std::vector<std::string> notes;
        for (const Message& note : run_notes(evaluated, source.in)) notes.push_back(source.in.say(note));
        add_list(parts, evaluated.analysis->name, std::move(notes));
    }
    if (parts.empty()) return;
    blocks.push_back(HeadingBlock{1, source.in.say(tell<"Notes">())});
    blocks.insert(blocks.end(), parts.begin(), parts.end());
}

std::string project_fingerprint(const ReportSource& source) {
    for (const EvaluatedAnalysis& evaluated : source.analyses)
        if (!evaluated.result->provenance.project_fingerprint.empty())
            return evaluated.result->provenance.project_fingerprint;
    return "–";
}

void add_provenance(Blocks& blocks, const ReportSource& source) {
    const DocumentLanguage& in = source.in;
    blocks.push_back(HeadingBlock{1, in.say(tell<"Provenance">())});
    TableBuilder table("provenance", tell<"Runs that gave these results">(), in);
    for (const Message& head : {tell<"Analysis">(), tell<"Model">(), tell<"Method">(), tell<"Trials">(),
                                tell<"Failed">(), tell<"Seed">(), tell<"Fingerprint">(), Message("Covaria")})
        table.text(head);
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const UncertaintyResult& result = *evaluated.result;
        table.row({evaluated.analysis->name, in.say_declared(evaluated.analysis->descriptor->title),
                   in.say(method_of(result)), count_text(result.trials, in.numbers()),
                   count_text(result.failed_trials, in.numbers()), std::to_string(result.provenance.seed),
                   evaluated.analysis->fingerprint(), result.provenance.covaria_version});
    }
    table.note(tell<"The same project, seed and version give the same numbers on any number of threads. The "
                    "fingerprint covers everything that influences the numbers of an analysis.">());
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
