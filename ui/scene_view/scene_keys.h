// The effects of keys on the camera of the scene.
#pragma once

#include <QPointF>
#include <optional>

#include "viz/scene/camera.h"

namespace covaria::ui {

/// The view of a key from 1 to 7.
std::optional<StandardView> view_of_key(int key);
/// Way of the mouse (pixels) that turns the camera as an arrow key does; null: it is none.
QPointF orbit_of_key(int key);

}  // namespace covaria::ui
