// A scene that is cut at a plane: where the plane begins, and what remains to be marked and pointed at.
#pragma once

#include <array>
#include <optional>

#include "viz/scene/camera.h"
#include "viz/scene/scene.h"

namespace covaria {

/// Positions of a plane across an axis at which it cuts anything: round numbers of the scene's unit.
struct SectionSteps {
    double step = 1e-3;         ///< m
    double first = 0.0;         ///< m
    int count = 1;              ///< of steps from the first to the last
    double at(int i) const;     ///< position of a step, m
    int nearest(double) const;  ///< the step that is nearest to a position, from 0 to `count`
};
SectionSteps steps_of_section(const Scene& scene, int axis);
/// The section through the middle of what the scene is about; what is cut away is the side of the eye.
SectionPlane middle_section(const Scene& scene, int axis, const Camera& camera);

/// Whether a section of the scene cuts this place away.
bool is_cut_away(const Scene& scene, const Eigen::Vector3d& p_W);
/// Ends of what a section leaves of a line; nullopt: nothing.
std::optional<std::array<Eigen::Vector3d, 2>> left_of_line(const Scene& scene, const Eigen::Vector3d& from,
                                                           const Eigen::Vector3d& to);

/// The scene without what is wholly cut away, its labels and marks; lines end at the plane. Solids that the
/// plane runs through stay whole: they are cut where they are drawn.
Scene left_by_section(Scene scene);

}  // namespace covaria
