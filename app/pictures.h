// Pictures of evaluated analyses, rendered off screen.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "app/evaluation.h"
#include "app/section_option.h"
#include "core/project/saved_view.h"
#include "core/result_files/results_json.h"
#include "viz/scene/scene.h"

namespace covaria {

/// The subject and the look of a picture of an analysis.
struct PictureRequest {
    std::string study = {};     ///< its map instead of the analysis' result
    std::string quantity = {};  ///< title of the study's quantity: "u(3D), B"; empty = the first
    bool ellipsoids = false;    ///< at the grid points of the study
    std::string design = {};    ///< its findings instead of the analysis' result
    std::string group = {};     ///< empty: the first group of outputs
    std::string view = "iso";
    std::optional<SavedView> saved = {};   ///< in place of the standard view
    std::optional<bool> perspective = {};  ///< empty: as saved, else orthographic
    std::optional<WantedSection> section = {};
    int width = 1280;
    int height = 800;
    bool dark = false;
    std::optional<double> magnification = {};
    double probability = 0.0;                      ///< 0: the analysis' coverage probability
    std::vector<LayoutMesh> context = {};          ///< meshes of the project: context_meshes
    std::vector<RequirementResult> verdicts = {};  ///< on the analysis' result
};

/// The scene of one group with ellipsoids and a cloud of replayed trials.
Result<Scene> scene_of(const EvaluatedAnalysis& evaluated, const PictureRequest& request);
/// Renders to a PNG file; a file called .gltf or .vtp gets the scene itself. Error{bad_input} names an
/// unknown group or view.
Result<void> write_picture(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                           const std::filesystem::path& file);
/// A picture of a run, with the name of its file.
struct PlannedPicture {
    std::size_t analysis = 0;
    std::string group = {};
    std::string view = {};                   ///< view of the scene; empty: the chart of an output
    std::optional<std::size_t> output = {};  ///< index of the charted output
    std::string file;
};
/// Pictures of every analysis: with a scene one per view of the first group, and the isometric view of every
/// other group; without one a chart for every output. No two have the same file.
std::vector<PlannedPicture> planned_pictures(const std::vector<EvaluatedAnalysis>& analyses);
/// The entry of a picture in results.json.
ResultFile listed(const PlannedPicture& picture, const std::vector<EvaluatedAnalysis>& analyses);
Result<void> write_pictures(const std::filesystem::path& folder,
                            const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<PlannedPicture>& pictures, const MadeProject& made,
                            const std::stop_token& stop);

}  // namespace covaria
