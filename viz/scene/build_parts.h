// The parts of build_scene: each adds one kind of item.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "viz/scene/build_scene.h"
#include "viz/scene/point_uncertainty.h"

namespace covaria::detail {

/// The tip of a vector as a point with uncertainty: its matrix takes the vector's unit to metres drawn.
struct VectorTip {
    LayoutPoint point;
    SceneItem item;
};

/// The inputs and the scene that all parts of a build share.
struct SceneBuild {
    const SceneSource& source;
    const SceneOptions& options;
    const PointUncertainties& uncertainties;
    const PointUncertainties&
        before;  ///< uncertainties in the results that are compared with; of none where there are none
    Scene& scene;
    std::set<std::string> ids = {};
    std::vector<VectorTip> tips = {};

    bool shows(const std::string& group) const { return group.empty() || group == scene.group; }
    /// "point:b1", made unique by "#2".
    std::string unique_id(const std::string& kind, const std::string& name);
};

/// Frames, points, bodies, links, vectors, in this order; `scene.size` is set first.
void add_items(SceneBuild& build);
/// Ellipsoids and clouds of the points, their magnification, and the caption.
void add_uncertainties(SceneBuild& build);
/// Plates at the bottom get feet, and everything a floor; what nothing rests on lies below ellipsoids and
/// clouds too, which it would cut.
void add_floor(Scene& scene);
/// Marks at the points and vectors that do not meet their requirements.
void add_verdicts(SceneBuild& build);
/// Histograms of one cloud on the walls of its bounding box.
void add_wall_histograms(SceneBuild& build);
void add_labels(SceneBuild& build);
/// Axes around everything, in place of those there were; unit of length, scale bar.
void add_axes(Scene& scene);
/// The magnification asked for, else the one that is held, else the automatic one.
double magnification_of(const SceneOptions& options, double automatic);
/// "ellipsoids 95 %, × 4 000".
std::string magnified_ellipsoids_words(const Scene& scene, const SceneOptions& options);
/// Adds a note that not all points show their uncertainty, where that is so.
void note_what_is_drawn(Scene& scene, std::size_t drawn, std::size_t all, const DocumentLanguage& in);
/// Ticks of a colour bar, at round numbers.
std::vector<AxisTick> colour_ticks(const SceneMap& map, const NumberLocale& numbers);
void add_legend(SceneBuild& build);

/// Outline moved outwards by `distance` with round corners; outlines that are not convex stay as they are.
std::vector<Eigen::Vector3d> rounded_outline(const std::vector<Eigen::Vector3d>& outline,
                                             const Eigen::Vector3d& normal, double distance);
/// Unit normal by Newell's sum, with positive z (or y, or x, where z is 0); UnitZ where undefined.
Eigen::Vector3d normal_of(const std::vector<Eigen::Vector3d>& outline);

}  // namespace covaria::detail
