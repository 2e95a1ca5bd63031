// Distributions as charts, and the picture of the set-up with its uncertainty.
#include <algorithm>

#include "core/base/name.h"
#include "core/model/has_layout.h"
#include "core/report/report_parts.h"
#include "core/text/numbers.h"
#include "core/views/plots.h"

namespace covaria::report_parts {

PlotBlock figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated, std::string caption) {
    plot.id = id_part(evaluated.analysis->id) + "-" + plot.id;
    return {std::move(plot), std::move(caption)};
}

PlotBlock titled_figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated) {
    std::string caption = to_unicode(plot.title) + ".";
    return figure(std::move(plot), evaluated, std::move(caption));
}

namespace {

std::size_t least_normal(const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    return *std::max_element(outputs.begin(), outputs.end(), [&](std::size_t a, std::size_t b) {
        const auto distance = [&](std::size_t i) {
            const double ratio = result.outputs[i].monte_carlo->normality.coverage_ratio;
            return ratio > 1.0 ? ratio - 1.0 : 1.0 - ratio;
        };
        return distance(a) < distance(b);
    });
}

void add_group(Blocks& blocks, const EvaluatedAnalysis& evaluated, const std::string& group,
               const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    std::vector<std::size_t> outputs = measurands_of(result, group);
    std::erase_if(outputs, [&](std::size_t i) { return !result.outputs[i].monte_carlo.has_value(); });
    if (outputs.empty()) return;
    for (const std::size_t i : outputs)
        blocks.push_back(
            figure(histogram_plot(result, i, {}, in), evaluated,
                   in.say(tell<"Distribution of %1.">(output_label(result.outputs[i].quantity)))));
    const std::size_t worst = least_normal(result, outputs);
    const Message label = output_label(result.outputs[worst].quantity);
    blocks.push_back(figure(
        normal_quantile_plot(result, worst, {}, in), evaluated,
        in.say(tell<"Quantiles of %1, the least normal, against those of a normal distribution.">(label))));
    if (!result.convergence.empty())
        blocks.push_back(
            figure(convergence_plot(result, worst, {}, in), evaluated,
                   in.say(tell<"Standard uncertainty of %1 against the number of trials.">(label))));
}

}  // namespace

void add_distributions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    if (evaluated.result->trials == 0) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Distributions">())});
    for (const std::string& group : groups_in_full(*evaluated.result))
        add_group(blocks, evaluated, group, in);
}

void add_scene(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (evaluated.analysis->model && !has_layout(*evaluated.analysis->model, result.inputs)) return;
    const std::vector<Name> shown = groups_in_full(result);
    const Name group = shown.empty() ? Name() : shown.front();
    blocks.push_back(HeadingBlock{2, in.say(tell<"Set-up in space">())});
    SceneBlock scene;
    scene.id = id_part(evaluated.analysis->id) + "-scene" + (group.empty() ? "" : "-" + id_part(group));
    scene.analysis = evaluated.analysis->id;
    scene.group = group;
    scene.view = "iso";
    scene.caption = in.say(
        tell<"%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.">(
            group.empty() ? Message(evaluated.analysis->name)
                          : evaluated.analysis->name + ", " + said_name(group),
            percent_text(result.coverage_probability, in.numbers())));
    blocks.push_back(std::move(scene));
}

}  // namespace covaria::report_parts
