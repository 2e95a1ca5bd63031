// From a layout and a result to a Scene: pure, for every model.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "core/model/layout.h"
#include "core/result/uncertainty_result.h"
#include "viz/scene/scene.h"

namespace covaria {

struct SceneOptions {
    std::string group = {};     ///< output group to show ("pose 7"); empty = the first
    double probability = 0.95;  ///< of ellipsoids
    std::optional<double> magnification =
        {};  ///< empty = automatic (a round number, so that the largest ellipsoid is seen)
    bool ellipsoids = true, clouds = true, wall_histograms = true, labels = true, links = true, bodies = true;
};

/// `result` and `trials` may be null (layout only; no clouds). `trials.outputs` and `.inputs` are columns of
/// trials.
struct SceneSource {
    const Layout* layout = nullptr;
    const UncertaintyResult* result = nullptr;
    const Eigen::MatrixXd* input_trials = nullptr;
    const Eigen::MatrixXd* output_trials = nullptr;
    std::string title = {};
};

Scene build_scene(const SceneSource& source, const SceneOptions& options);

}  // namespace covaria
