// Sobol indices beside the shares of the first order.
#include <algorithm>
#include <map>

#include "core/report/report_parts.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_indices = 16;

/// The share of the law of propagation that all components of the factor have.
double first_order_share(const UncertaintyResult& result, std::size_t output, const SobolIndex& index) {
    double share = 0.0;
    for (const BudgetRow& row : result.budget.rows[output])
        if (std::find(index.components.begin(), index.components.end(), row.component) !=
            index.components.end())
            share += row.share;
    return 100.0 * share;
}

TableBlock sobol_table(const EvaluatedAnalysis& evaluated, std::size_t output, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    const OutputQuantity& quantity = result.outputs[output].quantity;
    TableBuilder table(
        "sobol-" + evaluated.analysis->id + "-" + id_part(quantity.symbol + " " + quantity.group),
        tell<"Sobol indices of %1 in %">(output_label(quantity)), in);
    table.text(tell<"Component">());
    table.fixed(tell<"first order of the law of propagation">(), 1);
    table.fixed("S", 1);
    table.fixed(tell<"standard error of S">(), 1);
    table.fixed(tell<"S total">(), 1);
    table.fixed(tell<"standard error of S total">(), 1);
    const std::vector<SobolIndex>& indices = result.sobol[output];
    for (std::size_t i = 0; i < std::min(indices.size(), most_indices); ++i) {
        const SobolIndex& s = indices[i];
        table.row({s.name, first_order_share(result, output, s), 100.0 * s.first,
                   100.0 * s.first_standard_error, 100.0 * s.total, 100.0 * s.total_standard_error});
    }
    if (indices.size() > most_indices)
        table.note(tell<"%1 components with smaller indices are left out.">(indices.size() - most_indices));
    return table.take();
}

}  // namespace

void add_sobol(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.sobol.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Sobol indices">())});
    blocks.push_back(ParagraphBlock{
        in.say(
            tell<"S is the share of the variance that a component causes by itself, S total the share with "
                 "all its interactions with others: where both agree and the shares sum to 100 %, the "
                 "measurement model is additive. Components that are correlated have indices together. By "
                 "Monte Carlo with %1 pairs of trials.">(count_text(result.sobol_trials, in.numbers()))) +
        " " +
        in.say(tell<"Both are estimates by sampling, with the standard errors beside them: S can exceed S "
                    "total by chance.">())});
    for (const std::string& group : groups_in_full(result))
        for (const std::size_t output : measurands_of(result, group))
            blocks.push_back(sobol_table(evaluated, output, in));
}

}  // namespace covaria::report_parts
