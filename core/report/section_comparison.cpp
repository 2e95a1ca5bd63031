// The law of propagation beside Monte Carlo (JCGM 101 clause 8), and the shape of the distributions.
#include <algorithm>

#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

bool has_advice(const OutputResult& output) {
    return output.monte_carlo && !output.monte_carlo->normality.acceptable;
}

void add_verdict_words(Blocks& blocks, const UncertaintyResult& result, const DocumentLanguage& in) {
    std::size_t compared = 0, validated = 0, close = 0;
    for (const OutputResult& output : result.outputs) {
        if (!output.first_order.validation) continue;
        ++compared;
        if (output.first_order.validation->validated) ++validated;
        if (output.first_order.validation->is_close) ++close;
    }
    if (compared == 0) return;
    blocks.push_back(ParagraphBlock{
        in.say(tell<"The law of propagation is validated by JCGM 101 clause 8 where both ends of its "
                    "coverage interval, y ± U, lie within the numerical tolerance δ of those of the "
                    "propagation of distributions. Validated: %1 of %2.">(validated, compared)) +
        (close > 0
             ? " " + in.say(tell<"Of these verdicts, %1 could be the other one with other trials.">(close))
             : std::string())});
}

}  // namespace

void add_comparison(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.trials == 0) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Law of propagation beside Monte Carlo">())});
    add_verdict_words(blocks, result, in);
    TableBuilder table("comparison-" + evaluated.analysis->id,
                       tell<"Estimates and standard uncertainties by both methods">(), in);
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (result.outputs[i].monte_carlo) outputs.push_back(i);
    table.results(result, outputs,
                  {"symbol", "unit", "estimate first order", "mean", "u first order", "u Monte Carlo",
                   "ratio", "delta", "d_low", "d_high", "clause 8"});
    blocks.push_back(table.take());
    TableBuilder shapes("shapes-" + evaluated.analysis->id,
                        tell<"Shape of the distributions by Monte Carlo">(), in);
    shapes.results(result, outputs, {"symbol", "skewness", "excess kurtosis", "distribution in short"});
    if (std::any_of(result.outputs.begin(), result.outputs.end(), has_advice))
        shapes.note(
            tell<"Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage "
                 "interval.">());
    blocks.push_back(shapes.take());
}

}  // namespace covaria::report_parts
