// The camera of a scene: orthographic (a parallel projection, so that the scale bar holds everywhere in the
// picture), or perspective.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viz/scene/scene.h"

namespace covaria {

/// Standard views; iso looks from the front right, from above; the others along -z, +y, -x, +z, -y, +x.
enum class StandardView { iso, top, front, right, bottom, back, left };
inline constexpr std::size_t standard_view_count = 7;
std::optional<StandardView> standard_view_from(std::string_view key);  ///< "iso", "top", "front" ...
/// Directions of a standard view: from the eye into the scene, and the one that is up in the picture.
struct ViewDirections {
    Eigen::Vector3d direction, up;
};
ViewDirections directions_of(StandardView view);

struct Camera {
    Eigen::Vector3d focal_point = Eigen::Vector3d::Zero();  ///< seen in the middle of the picture, m
    Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  ///< unit vector, from the eye into the scene
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();          ///< unit vector, perpendicular to direction
    double half_height = 1.0;                               ///< half of the picture, m at the focal point
    bool perspective = false;  ///< with an angle of view of 30 degrees from its bottom to its top
    /// Distance of the eye from the focal point in a perspective, m.
    double eye_distance() const;
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

/// Size of a pixel at the focal point; in a perspective less before it and more behind it, as at `p_W`.
double metres_per_pixel(const Camera& camera, PictureSize size);
double metres_per_pixel(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W);
Pixel project(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W);
/// The point of W under a pixel, in the plane through `through_W` parallel to the picture (for dragging).
Eigen::Vector3d world_at(const Camera& camera, PictureSize size, Pixel pixel,
                         const Eigen::Vector3d& through_W);

/// The line of sight through a pixel: its origin, and its direction into the scene.
struct Ray {
    Eigen::Vector3d origin, direction;
};
Ray ray_through(const Camera& camera, PictureSize size, Pixel pixel);

/// The camera that looks along a standard direction with the whole box in the picture.
Camera view_of(const SceneBounds& bounds, StandardView view, PictureSize size, double room = 0.0,
               bool perspective = false);
std::array<Eigen::Vector3d, 8> corners_of(const SceneBounds& bounds);
/// The camera in the same direction with the whole box in the picture and a margin for captions: `room`
/// pixels at least (letters do not shrink with the picture), though never more than a quarter of a side.
Camera fitted(const Camera& camera, const SceneBounds& bounds, PictureSize size, double room = 0.0);

/// The same picture with `foot` more pixels below it.
Camera with_foot(const Camera& camera, PictureSize size, int foot);

/// Whether the high side of a box along `axis` (0 x, 1 y, 2 z) is farther from the eye than the low. Where
/// neither is, the answer puts the axes of the plane views below and to the left.
bool far_side_is_high(const Camera& camera, int axis);

/// Drag by (dx, dy) pixels: turns about the focal point, z stays upright (a full picture width = 360 deg).
Camera orbited(const Camera& camera, PictureSize size, double dx, double dy);
/// Drag by (dx, dy) pixels: the object under the pointer follows it.
Camera panned(const Camera& camera, PictureSize size, double dx, double dy);
/// factor > 1 shows things larger.
Camera zoomed(const Camera& camera, double factor);
/// Zooms about a pixel: the point under it, in the plane through the focal point, stays there.
Camera zoomed(const Camera& camera, double factor, PictureSize size, Pixel about);

}  // namespace covaria
