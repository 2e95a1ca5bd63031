// Designs in a report: what was asked, what was found, what each row and each target is worth.
#include "core/report/design_plots.h"
#include "core/report/design_results.h"
#include "core/report/report_parts.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {

namespace {

constexpr std::size_t most_printed = 30;  // rows of a table

std::string what_was_found(const DesignResult& design) {
    std::string words = "Looked for: the smallest " + design.objective_words + ". ";
    if (design.cost)
        words = std::string("Looked for: the cheapest ") +
                (design.rows.empty() ? "reductions of uncertainty" : "rows") +
                " with which all targets are met. ";
    if (!design.found) return words + "Nothing that was tried has a result.";
    words += count_text(design.evaluations) +
             " candidates were evaluated by the law of propagation of uncertainty";
    words += design.proved ? ", all that there are. " : ". ";
    if (design.cost)
        words += "Cost: " + format_significant(*design.cost, 4) + ". ";
    else
        words += "Found: " + format_significant(design.objective, 4) +
                 (design.before ? ", before " + format_significant(*design.before, 4) : "") + ". ";
    if (design.trials > 0) words += "Verified by Monte Carlo with " + count_text(design.trials) + " trials. ";
    return words + (design.met() ? "" : "Not every target is met: what is given is the best that was found.");
}

SceneBlock scene_of(const DesignResult& design) {
    SceneBlock scene;
    scene.id = id_part(design.analysis) + "-design-" + id_part(design.id);
    scene.analysis = design.analysis;
    scene.design = design.id;
    scene.view = "iso";
    scene.caption = design.name + ": ";
    scene.caption += design.rows.empty()
                         ? "the way of the search to the best place, coloured by the objective."
                         : "the candidates, coloured by what they gain; the larger ones are chosen.";
    return scene;
}

}  // namespace

void add_designs(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    if (evaluated.designs.empty()) return;
    blocks.push_back(HeadingBlock{2, "Designs"});
    for (const auto& design : evaluated.designs) {
        blocks.push_back(HeadingBlock{3, design->name});
        blocks.push_back(ParagraphBlock{what_was_found(*design)});
        for (DataTable& table : readable_design_tables(*design)) {
            if (table.rows.size() > most_printed) continue;
            table.id = "design-" + design->id + "-" + table.id;
            table.title = design->name + ": " + table.title;
            blocks.push_back(TableBlock{std::move(table), {}});
        }
        if (stands_in_space(*design)) blocks.push_back(scene_of(*design));
        for (PlotSpecification& plot : design_plots(*design)) {
            std::string caption = to_unicode(plot.title) + ".";
            blocks.push_back(figure(std::move(plot), evaluated, std::move(caption)));
        }
    }
}

}  // namespace covaria::report_parts
