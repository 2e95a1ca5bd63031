// Input quantities that are outputs of other analyses.
#include "core/report/report_parts.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

std::string upstream_title(const LinkedInput& input) {
    return input.analysis_name.empty() ? input.analysis : input.analysis_name;
}

void add_words_about_links(Blocks& blocks, const std::vector<LinkedInput>& linked,
                           const DocumentLanguage& in) {
    blocks.push_back(ParagraphBlock{
        in.say(tell<"These input quantities are results of other analyses. All are evaluated together as one "
                    "model, in every trial, so that the budget goes down to the components of the analyses "
                    "that they come from; a component that reaches the result on several ways is one "
                    "component.">())});
    for (const LinkedInput& input : linked)
        if (input.linearised) {
            blocks.push_back(ParagraphBlock{
                in.say(tell<"Linearised: the analysis that the value comes from is replaced by its law of "
                            "propagation about its estimates. That is exact to first order; its "
                            "non-linearity is left out of Monte Carlo.">())});
            return;
        }
}

}  // namespace

void add_links(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const std::vector<LinkedInput>& linked = evaluated.analysis->linked;
    if (linked.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Where the inputs come from">())});
    add_words_about_links(blocks, linked, in);
    TableBuilder table("links-" + evaluated.analysis->id,
                       tell<"Input quantities taken from other analyses">(), in);
    table.text(tell<"Symbol">(), true);
    table.text(tell<"Quantity">());
    table.number(tell<"Estimate">()).estimate_of("u");
    table.text(tell<"Unit">());
    table.symbol("u(x_i)", "u").uncertainty();
    table.symbol("nu_i").degrees_of_freedom();
    table.text(tell<"Analysis">());
    table.text(tell<"Its result">());
    for (const LinkedInput& input : linked)
        table.row(
            {input.symbol, in.say(input.name), value_in(input.unit, input.estimate), input.unit,
             interval_in(input.unit, input.standard_uncertainty), input.degrees_of_freedom,
             input.linearised ? in.say(tell<"%1, linearised">(upstream_title(input))) : upstream_title(input),
             in.say(output_label(input.output))});
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
