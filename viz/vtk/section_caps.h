// The faces in the plane of a section where it opens solids.
#pragma once

#include "viz/vtk/layer_actors.h"

namespace covaria::detail {

/// Faces of one colour, which needs no order among solids that run into each other, with the outline of every
/// solid; nothing where the scene has no section or none of the solids is in its plane.
std::vector<LayerActor> cap_actors(const std::vector<Solid>& solids, const Scene& scene,
                                   const Eigen::Vector3d& origin, ScenePalette palette);

}  // namespace covaria::detail
