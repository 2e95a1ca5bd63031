// What keys do to the camera of the scene.
#pragma once

#include <QPointF>
#include <optional>

#include "viz/scene/camera.h"

namespace covaria::ui {

/// 1 to 7.
std::optional<StandardView> view_of_key(int key);
/// By which way of the mouse an arrow key turns it, pixels; null: it is none.
QPointF orbit_of_key(int key);

}  // namespace covaria::ui
