// Canonical text of a scene, for tests without OpenGL.
#pragma once

#include <string>

#include "viz/scene/scene.h"

namespace covaria {

/// One line per item in the order of the scene, lengths in mm to 0.001 mm; clouds as their size and the
/// standard deviations of their coordinates.
std::string dump_scene(const Scene& scene);

}  // namespace covaria
