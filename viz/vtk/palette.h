// Roles to colours, on a light and on a dark ground (Okabe and Ito's palette for categories).
#pragma once

#include <array>
#include <cstdint>

#include "viz/scene/scene.h"
#include "viz/scene/solids.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::detail {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

Colour colour_of(Role role, ScenePalette palette);
Colour colour_of(MeshColour colour, ScenePalette palette);
Colour colour_of(Material material, ScenePalette palette);
/// Perceptually uniform magnitude, 0 <= t <= 1 (clamped): control points of viridis (S. van der Walt, N.
/// Smith, 2015, CC0), interpolated.
Colour magnitude_colour(double t);
Colour ground_colour(ScenePalette palette);
Colour floor_colour(ScenePalette palette);      ///< floor under everything; it fades into the ground
Colour grid_colour(ScenePalette palette);       ///< lines of the axes' walls
Colour selection_colour(ScenePalette palette);  ///< ring around the selected item
Colour inside_colour(ScenePalette palette);     ///< where a section has opened solids

}  // namespace covaria::detail
