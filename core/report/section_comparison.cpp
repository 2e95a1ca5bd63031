// The law of propagation beside Monte Carlo (JCGM 101 clause 8), and the shape of the distributions.
#include <algorithm>

#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

std::string verdict_text(const FirstOrderOutput& first) {
    if (!first.validation) return "–";
    return first.validation->validated ? "validated" : "not validated";
}

/// Without the advice after the colon, which stands below the table.
std::string distribution_text(const MonteCarloOutput& trials) {
    return trials.normality.words.substr(0, trials.normality.words.find(':'));
}

bool has_advice(const OutputResult& output) {
    return output.monte_carlo && output.monte_carlo->normality.words.find(':') != std::string::npos;
}

std::vector<TableCell> comparison_row(const OutputResult& output) {
    const Unit& unit = output.quantity.unit;
    const FirstOrderOutput& first = output.first_order;
    const MonteCarloOutput& trials = *output.monte_carlo;
    std::vector<TableCell> row = {output.quantity.symbol,
                                  unit_text(unit),
                                  value_in(unit, first.estimate),
                                  value_in(unit, trials.mean),
                                  interval_in(unit, first.standard_uncertainty),
                                  interval_in(unit, trials.standard_uncertainty)};
    row.push_back(trials.standard_uncertainty > 0.0
                      ? TableCell(first.standard_uncertainty / trials.standard_uncertainty)
                      : TableCell{});
    if (first.validation)
        for (const double d :
             {first.validation->tolerance, first.validation->d_low, first.validation->d_high})
            row.emplace_back(interval_in(unit, d));
    else
        row.resize(row.size() + 3);
    row.insert(row.end(),
               {TableCell(verdict_text(first)), trials.skewness, trials.kurtosis, distribution_text(trials)});
    return row;
}

void add_verdict_words(Blocks& blocks, const UncertaintyResult& result) {
    std::size_t compared = 0, validated = 0;
    for (const OutputResult& output : result.outputs) {
        if (!output.first_order.validation) continue;
        ++compared;
        if (output.first_order.validation->validated) ++validated;
    }
    if (compared == 0) return;
    blocks.push_back(ParagraphBlock{
        "The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, "
        "y ± U, "
        "lie within the numerical tolerance δ of those of the propagation of distributions: so for " +
        std::to_string(validated) + " of " + std::to_string(compared) + " quantities."});
}

}  // namespace

void add_comparison(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.trials == 0) return;
    blocks.push_back(HeadingBlock{2, "Law of propagation beside Monte Carlo"});
    add_verdict_words(blocks, result);
    TableBuilder table("comparison-" + evaluated.analysis->id,
                       "Estimates and standard uncertainties by both methods");
    table.text("Quantity", true);
    table.text("Unit");
    table.number("y at the estimates", 0, 4);
    table.number("mean Monte Carlo", 0, 5);
    table.number("u law of prop.", 3);
    table.number("u Monte Carlo", 3);
    table.fixed("ratio", 3);
    table.symbol("delta", 1);
    table.symbol("d_low", 0, 7);
    table.symbol("d_high", 0, 7);
    table.text("Clause 8");
    table.fixed("skewness", 3);
    table.fixed("excess kurtosis", 3);
    table.text("Distribution");
    std::string group;
    for (const OutputResult& output : result.outputs) {
        if (!output.monte_carlo) continue;
        if (output.quantity.group != group) table.subhead(output.quantity.group);
        group = output.quantity.group;
        table.row(comparison_row(output));
    }
    if (std::any_of(result.outputs.begin(), result.outputs.end(), has_advice))
        table.note(
            "Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.");
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
