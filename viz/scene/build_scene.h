// Makes a Scene of a layout and a result: pure, for every model.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/layout.h"
#include "core/project/links.h"
#include "core/result/comparison.h"
#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "viz/scene/scene.h"

namespace covaria {

struct SceneOptions {
    std::string group = {};     ///< output group to show ("pose 7"); empty = the first
    double probability = 0.95;  ///< coverage probability of ellipsoids
    std::optional<double> magnification =
        {};  ///< empty = automatic (a round number, so that the largest ellipsoid is seen)
    /// Held in place of the automatic one: that of the picture before, while something is dragged in it.
    std::optional<double> held_magnification = {};
    bool ellipsoids = true, clouds = true, wall_histograms = true, labels = true, links = true, bodies = true;
    std::size_t cloud_limit = 20'000;  ///< points of each cloud; more trials are thinned evenly
    std::string histograms_of = {};    ///< name of the point; empty = the first with output quantities
    DocumentLanguage language = {};    ///< language of the scene's texts; names stay
    DisplayUnits units = {};  ///< inches where the unit of lengths is one of theirs, else metres by size
    std::vector<RequirementResult> verdicts = {};  ///< on the result: what is not met is marked
    std::vector<LayoutMesh> context = {};  ///< drawn around a layout that is not empty (context_meshes)
};

/// `result` and the trials may be null (layout only; no clouds). Column t of the trials is trial t, as
/// `replay_trials` gives them; trials with NaN are left out.
struct SceneSource {
    const Layout* layout = nullptr;
    const UncertaintyResult* result = nullptr;
    const Eigen::MatrixXd* input_trials = nullptr;
    const Eigen::MatrixXd* output_trials = nullptr;
    std::string title = {};
    const SceneMap* map = nullptr;  ///< the map of a study
    /// Comparison with `result` as the later one: ellipsoids of both are drawn. Null: nothing is compared.
    const ResultComparison* compared = nullptr;
    const std::vector<LinkedPoint>* linked = nullptr;  ///< points that the analysis takes from others
};

/// Pure: the same arguments give the same scene. Never fails: what has no value (no result, no uncertainty)
/// is left out.
Scene build_scene(const SceneSource& source, const SceneOptions& options);

}  // namespace covaria
