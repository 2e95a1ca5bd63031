// The context of a project: meshes that are drawn in the scenes of all its analyses.
#pragma once

#include <vector>

#include "core/made/made_project.h"
#include "core/model/layout.h"

namespace covaria {

/// Those of all its assets, in the order of the project, named after their assets. What was not made has
/// none.
std::vector<LayoutMesh> context_meshes(const MadeProject& made);

}  // namespace covaria
