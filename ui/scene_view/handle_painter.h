// Paints what can be grasped of an item in the scene: the arrows that move it and the tips that turn it.
#pragma once

#include "viz/scene/handles.h"
#include "viz/vtk/palette.h"

class QPainter;

namespace covaria::ui {

/// `grasped`: the axis of the arrow under the pointer, -1: none; `ratio`: device pixels in one of the
/// painter's.
void paint_handles(QPainter& painter, const HandleMarks& marks, int grasped, ScenePalette colours,
                   double ratio);

}  // namespace covaria::ui
