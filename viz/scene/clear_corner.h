// A scene that keeps clear of the legend in the corner of its picture.
#pragma once

#include "viz/scene/camera.h"
#include "viz/scene/label_placement.h"

namespace covaria {

/// A fitted camera, moved so that the box is beside or below `taken`, which stands in the upper left corner;
/// a little farther away where that needs more room than there is. `room`: pixels beside and below the box
/// that belong to it, its figures. Unchanged where nothing is covered, or where that would make the scene too
/// small.
Camera clear_of_corner(const Camera& camera, const SceneBounds& bounds, PictureSize size,
                       const ScreenRect& taken, double room);

}  // namespace covaria
