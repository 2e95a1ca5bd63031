// U without one contributor (an ideal robot), and of that contributor alone.
#include "core/base/name.h"
#include "core/report/report_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_columns = 4;  ///< contributors in one table

void add_words(Blocks& blocks, const UncertaintyResult& result, const DocumentLanguage& in) {
    const Message what = tell<
        "The expanded uncertainty U beside what remains of it when everything that a contributor "
        "brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with "
        "the same coverage factor.">();
    const Message how =
        result.contributor_trials > 0
            ? tell<"By Monte Carlo with %1 trials.">(count_text(result.contributor_trials, in.numbers()))
            : tell<"By the law of propagation.">();
    blocks.push_back(ParagraphBlock{in.say(what) + " " + in.say(how)});
    for (const ContributorResult& c : result.contributors)
        if (c.without.failed_trials > 0)
            blocks.push_back(ParagraphBlock{in.say(tell<"Without %1, %2 trials had no value.">(
                contributor_title(c), count_text(c.without.failed_trials, in.numbers())))});
}

/// The table with the contributors first ... last - 1 as columns.
TableBlock contributor_table(const EvaluatedAnalysis& evaluated, std::size_t first, std::size_t last,
                             const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    TableBuilder table(
        "contributors-" + evaluated.analysis->id + (first == 0 ? "" : "-" + std::to_string(first)),
        tell<"U without each contributor, and of it alone">(), in);
    table.text(tell<"Quantity">(), true);
    table.text(tell<"Unit">());
    table.symbol("U").uncertainty(3);
    const bool two = result.contributors.size() == 2;
    for (std::size_t i = first; i < last; ++i) {
        const Message title = contributor_title(result.contributors[i]);
        table.number(tell<"without %1">(title)).uncertainty(3);
        if (!two) table.number(tell<"%1 alone">(title)).uncertainty(3);
    }
    std::string group;
    for (std::size_t j = 0; j < result.outputs.size(); ++j) {
        const OutputResult& output = result.outputs[j];
        const Unit& unit = output.quantity.unit;
        if (output.quantity.group != group) table.subhead(said_name(output.quantity.group));
        group = output.quantity.group;
        std::vector<Cell> row = {output.quantity.symbol, unit,
                                 interval_in(unit, output.expanded_uncertainty)};
        for (std::size_t i = first; i < last; ++i) {
            const ContributorResult& c = result.contributors[i];
            row.emplace_back(interval_in(unit, expanded_with(output, c.without, j)));
            if (!two) row.emplace_back(interval_in(unit, expanded_with(output, c.alone, j)));
        }
        table.row(std::move(row));
    }
    if (two)
        table.note(tell<"Of two contributors, what remains without one is what the other gives alone.">());
    return table.take();
}

}  // namespace

void add_contributors(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.contributors.size() < 2) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Results by contributor">())});
    add_words(blocks, result, in);
    for (std::size_t first = 0; first < result.contributors.size(); first += most_columns)
        blocks.push_back(contributor_table(evaluated, first,
                                           std::min(first + most_columns, result.contributors.size()), in));
}

}  // namespace covaria::report_parts
