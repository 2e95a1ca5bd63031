// Files of Comp3D that stand alone: coordinates as an artefact, observations as quantities.
#pragma once

#include <string>

#include "core/readers/reader.h"

namespace covaria {

Result<Proposals> read_comp3d_coordinates(const std::string& text, const ReadChoice& choice);
Result<Proposals> read_comp3d_quantities(const std::string& text, const ReadChoice& choice);

}  // namespace covaria
