// The scene of an analysis: its layout, its result, and a cloud of trials regenerated for the picture.
#pragma once

#include "core/project/workspace.h"
#include "viz/scene/build_scene.h"

namespace covaria {

/// Layout at the estimates, ellipsoids of `result` and clouds of its first trials. `result` may be null:
/// layout only. Clouds are drawn only of results that Monte Carlo made. Error: the model has no value at the
/// estimates.
Result<Scene> analysis_scene(const PreparedAnalysis& analysis, const UncertaintyResult* result,
                             const SceneOptions& options);

}  // namespace covaria
