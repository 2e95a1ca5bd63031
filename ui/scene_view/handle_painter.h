// Handles of an item in the scene, painted and in words: the arrows that move it, the tips that
// turn it.
#pragma once

#include <QString>

#include "viz/scene/handles.h"
#include "viz/vtk/palette.h"

class QPainter;

namespace covaria::ui {

/// `grasped`: the axis of the arrow under the pointer, -1: none; `ratio`: device pixels in one of the
/// painter's.
void paint_handles(QPainter& painter, const HandleMarks& marks, int grasped, ScenePalette colours,
                   double ratio);

/// "Turns about its x axis", what a drag by it does; empty: it moves freely.
QString handle_words(const Handle& handle, const Camera& camera);

}  // namespace covaria::ui
