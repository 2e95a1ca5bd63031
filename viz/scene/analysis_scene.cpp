#include "viz/scene/analysis_scene.h"

#include "core/propagation/engine.h"

namespace covaria {
namespace {

std::vector<double> estimates(const InputSet& inputs) {
    std::vector<double> x(inputs.quantities.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = estimate_of(inputs, i);
    return x;
}

}  // namespace

Result<Scene> analysis_scene(const PreparedAnalysis& analysis, const UncertaintyResult* result,
                             const SceneOptions& options, const ResultComparison* compared) {
    const Layout layout = analysis.model->layout(estimates(analysis.inputs));
    SceneSource source{.layout = &layout,
                       .result = result,
                       .title = analysis.name,
                       .compared = compared,
                       .linked = &analysis.linked_points};
    if (!result || result->trials == 0 || !options.clouds) return build_scene(source, options);
    const auto trials = replay_trials(*analysis.propagated, analysis.options.seed, 0,
                                      std::min<std::uint64_t>(options.cloud_limit, result->trials));
    if (!trials) return fail(trials.error());
    source.input_trials = &trials->inputs;
    source.output_trials = &trials->outputs;
    return build_scene(source, options);
}

std::map<std::string, std::string> groups_of_sources(const PreparedAnalysis& analysis) {
    std::map<std::string, std::string> groups;
    for (const LayoutPoint& point : analysis.model->layout(estimates(analysis.inputs)).points)
        if (!point.source.path.empty()) groups.emplace(point.source.path, point.group);
    return groups;
}

}  // namespace covaria
