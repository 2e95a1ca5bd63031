// Designs in a report: the question, the answer, and the worth of each row and each target.
#include <algorithm>

#include "core/report/report_parts.h"
#include "core/text/numbers.h"
#include "core/views/design_plots.h"
#include "core/views/design_results.h"

namespace covaria::report_parts {

namespace {

constexpr std::size_t most_printed = 30;  // rows of a table

Message what_was_looked_for(const DesignResult& design) {
    if (!design.cost) return tell<"Looked for: the smallest %1.">(Message::declared(design.objective_words));
    return design.rows.empty()
               ? tell<"Looked for: the cheapest reductions of uncertainty with which all targets are met.">()
               : tell<"Looked for: the cheapest rows with which all targets are met.">();
}

Message what_came_out(const DesignResult& design, const DocumentLanguage& in) {
    const auto number = [&in](double value) {
        return grouped_digits(format_significant(value, 4), in.numbers());
    };
    if (design.cost) return tell<"Cost: %1.">(number(*design.cost));
    return design.before ? tell<"Found: %1, before %2.">(number(design.objective), number(*design.before))
                         : tell<"Found: %1.">(number(design.objective));
}

std::string what_was_found(const DesignResult& design, const DocumentLanguage& in) {
    std::string words = in.say(what_was_looked_for(design)) + " ";
    if (!design.found) return words + in.say(tell<"Nothing that was tried has a result.">());
    const std::string evaluations = count_text(design.evaluations, in.numbers());
    words += in.say(
        design.proved
            ? tell<"%1 candidates were evaluated by the law of propagation of uncertainty, all that there "
                   "are.">(evaluations)
            : tell<"%1 candidates were evaluated by the law of propagation of uncertainty.">(evaluations));
    words += " " + in.say(what_came_out(design, in)) + " ";
    if (design.trials > 0)
        words +=
            in.say(tell<"Verified by Monte Carlo with %1 trials.">(count_text(design.trials, in.numbers()))) +
            " ";
    if (!design.met())
        words += in.say(tell<"Not every target is met: what is given is the best that was found.">());
    return words;
}

SceneBlock scene_of(const DesignResult& design, const DocumentLanguage& in) {
    SceneBlock scene;
    scene.id = id_part(design.analysis) + "-design-" + id_part(design.id);
    scene.analysis = design.analysis;
    scene.design = design.id;
    scene.view = "iso";
    scene.caption = in.say(
        design.rows.empty()
            ? tell<"%1: the way of the search to the best place, coloured by the objective.">(design.name)
            : tell<"%1: the candidates, coloured by what they gain; the larger ones are chosen.">(
                  design.name));
    return scene;
}

}  // namespace

void add_designs(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    if (evaluated.designs.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Designs">())});
    for (const auto& design : evaluated.designs) {
        blocks.push_back(HeadingBlock{3, design->name});
        blocks.push_back(ParagraphBlock{what_was_found(*design, in)});
        for (Table& table : readable_design_tables(*design)) {
            if (table.rows > most_printed) continue;
            table.id = "design-" + design->id + "-" + table.id;
            TableBlock block = evaluation_block(table, in);
            block.table.title = design->name + ": " + block.table.title;
            blocks.push_back(std::move(block));
        }
        if (stands_in_space(*design)) blocks.push_back(scene_of(*design, in));
        for (PlotSpecification& plot : design_plots(*design, in))
            blocks.push_back(titled_figure(std::move(plot), evaluated));
    }
}

}  // namespace covaria::report_parts
