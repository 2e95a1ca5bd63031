// The camera of a scene: parallel projection, so that the scale bar holds everywhere in the picture.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "viz/scene/scene.h"

namespace covaria {

/// Standard views; iso looks from the front right, from above; the others along -z, +y, -x.
enum class StandardView { iso, top, front, right };
std::optional<StandardView> standard_view_from(std::string_view key);  ///< "iso", "top", "front", "right"

struct Camera {
    Eigen::Vector3d focal_point = Eigen::Vector3d::Zero();  ///< seen in the middle of the picture, m
    Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  ///< unit vector, from the eye into the scene
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();          ///< unit vector, perpendicular to direction
    double half_height = 1.0;                               ///< of the picture, m at the scale of the scene
    Eigen::Vector3d right() const { return direction.cross(up); }
    bool operator==(const Camera&) const = default;
};

/// Pixel position: x to the right and y down from the upper left corner.
struct Pixel {
    double x = 0.0;
    double y = 0.0;
};

struct PictureSize {
    int width = 1280;
    int height = 800;
    bool operator==(const PictureSize&) const = default;
};

double metres_per_pixel(const Camera& camera, PictureSize size);
Pixel project(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W);
/// The point of W under a pixel, in the plane through `through_W` parallel to the picture (for dragging).
Eigen::Vector3d world_at(const Camera& camera, PictureSize size, Pixel pixel,
                         const Eigen::Vector3d& through_W);

/// Looking along a standard direction with the whole box in the picture.
Camera view_of(const SceneBounds& bounds, StandardView view, PictureSize size, double room = 0.0);
/// Same direction, the whole box in the picture with a margin for captions: `room` pixels at least (letters
/// do not shrink with the picture), though never more than a quarter of a side.
Camera fitted(const Camera& camera, const SceneBounds& bounds, PictureSize size, double room = 0.0);

/// Is the high side of a box along `axis` (0 x, 1 y, 2 z) farther from the eye than its low side? Where
/// neither is, the answer puts the axes of the plane views below and to the left.
bool far_side_is_high(const Camera& camera, int axis);

/// Drag by (dx, dy) pixels: turns about the focal point, z stays upright (a full picture width = 360 deg).
Camera orbited(const Camera& camera, PictureSize size, double dx, double dy);
/// What is under the pointer follows it.
Camera panned(const Camera& camera, PictureSize size, double dx, double dy);
/// factor > 1 shows things larger.
Camera zoomed(const Camera& camera, double factor);

}  // namespace covaria
