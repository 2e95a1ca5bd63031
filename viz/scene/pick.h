// The item under a pixel: by geometry, without OpenGL.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "viz/scene/camera.h"
#include "viz/scene/scene.h"

namespace covaria {

/// Id of the item under the pixel, or empty. Small things win over large ones that they lie on or in: points,
/// then frames (their origin), vectors, ellipsoids, links, bodies; among equals what the pixel lies on or
/// least beside, then the nearest to the eye. `reach` is how far beside a thin thing one may point, in
/// pixels.
std::optional<std::string> pick_item(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                     const std::function<bool(Layer)>& shown, double reach = 6.0);

}  // namespace covaria
