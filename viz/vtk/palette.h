// Roles to colours, on a light and on a dark ground (Okabe and Ito's palette for categories).
#pragma once

#include <array>
#include <cstdint>

#include "viz/scene/scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::detail {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

Colour colour_of(Role role, ScenePalette palette);
/// The ground fades from top to bottom.
Colour ground_top(ScenePalette palette);
Colour ground_bottom(ScenePalette palette);
Colour grid_colour(ScenePalette palette);       ///< lines of the axes' walls
Colour selection_colour(ScenePalette palette);  ///< ring around the selected item

}  // namespace covaria::detail
