// Arms of robots: how thick their links are, and where the joints between them sit.
#pragma once

#include "viz/scene/scene.h"

namespace covaria::detail {

/// Gives the links of each arm radii that get smaller from its base to its flange, in proportion to its
/// reach, and makes those axes drums that pass through it. Axes elsewhere stay lines.
void shape_arms(Scene& scene);

}  // namespace covaria::detail
