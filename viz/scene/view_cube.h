// The cube in a corner of the window's scene: it turns with the camera, a click on a face looks at it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viz/scene/camera.h"

namespace covaria {

/// A face that is turned to the eye, in pixels.
struct CubeFace {
    StandardView view = StandardView::front;
    std::array<Pixel, 4> corners;  ///< as its letters stand: upper left, upper right, lower right, lower left
    double towards_eye = 0.0;      ///< 1: seen straight on; 0: from its edge
};

/// The faces towards the eye (at most three) of a cube with edges of `edge` pixels about `centre`, without
/// perspective.
std::vector<CubeFace> view_cube(const Camera& camera, Pixel centre, double edge);
/// The face under a pixel.
std::optional<StandardView> face_at(const std::vector<CubeFace>& faces, Pixel pixel);

}  // namespace covaria
