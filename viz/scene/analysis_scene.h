// The scene of an analysis: its layout, its result, and a cloud of trials regenerated for the picture.
#pragma once

#include <map>
#include <string>

#include "core/made/prepared_analysis.h"
#include "viz/scene/build_scene.h"

namespace covaria {

/// Layout at the estimates, ellipsoids of `result` and clouds of its first trials. `result` may be null:
/// layout only. Clouds are drawn only of results that Monte Carlo made. `compared` adds the ellipsoids
/// of the results before. Error: the model has no value at the estimates.
Result<Scene> analysis_scene(const PreparedAnalysis& analysis, const UncertaintyResult* result,
                             const SceneOptions& options, const ResultComparison* compared = nullptr);

/// The first group that shows each set-up field from which a point comes.
std::map<std::string, std::string> groups_of_sources(const PreparedAnalysis& analysis);

}  // namespace covaria
