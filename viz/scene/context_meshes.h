// The context of a project: meshes that are drawn in the scenes of all its analyses.
#pragma once

#include <vector>

#include "core/made/made_project.h"
#include "core/model/layout.h"

namespace covaria {

/// Meshes of all assets of the project, in its order, named after their assets. Assets not made have
/// none.
std::vector<LayoutMesh> context_meshes(const MadeProject& made);

}  // namespace covaria
