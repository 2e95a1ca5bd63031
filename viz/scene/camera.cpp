// Parallel projection: standard views, fit, orbit, pan, zoom.
#include "viz/scene/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria {
namespace {

constexpr double smallest_half_height = 1e-9;
constexpr double largest_half_height = 1e9;

double aspect(PictureSize size) {
    return static_cast<double>(size.width) / std::max(1, size.height);
}

Camera looking_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& upward) {
    Camera camera;
    camera.direction = direction.normalized();
    camera.up = (upward - upward.dot(camera.direction) * camera.direction).normalized();
    return camera;
}

}  // namespace

std::optional<StandardView> standard_view_from(std::string_view key) {
    if (key == "iso") return StandardView::iso;
    if (key == "top") return StandardView::top;
    if (key == "front") return StandardView::front;
    if (key == "right") return StandardView::right;
    return std::nullopt;
}

double metres_per_pixel(const Camera& camera, PictureSize size) {
    return 2 * camera.half_height / std::max(1, size.height);
}

Pixel project(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W) {
    const Eigen::Vector3d d = p_W - camera.focal_point;
    const double scale = 1 / metres_per_pixel(camera, size);
    return {size.width / 2.0 + scale * d.dot(camera.right()), size.height / 2.0 - scale * d.dot(camera.up)};
}

Eigen::Vector3d world_at(const Camera& camera, PictureSize size, Pixel pixel,
                         const Eigen::Vector3d& through_W) {
    const double scale = metres_per_pixel(camera, size);
    const double depth = (through_W - camera.focal_point).dot(camera.direction);
    return camera.focal_point + scale * (pixel.x - size.width / 2.0) * camera.right() -
           scale * (pixel.y - size.height / 2.0) * camera.up + depth * camera.direction;
}

Camera fitted(const Camera& camera, const SceneBounds& bounds, PictureSize size, double room) {
    constexpr double margin = 1.17;  // room for the axis titles, the title line and the caption
    const Eigen::Vector3d extent = bounds.high - bounds.low;
    const double width = extent.dot(camera.right().cwiseAbs());
    const double height = extent.dot(camera.up.cwiseAbs());
    const double half = std::max(height, width / aspect(size)) / 2;
    const auto with_room = [room](double pixels) {
        return pixels / (pixels - 2 * std::min(room, pixels / 4));
    };
    const double needed = std::max(height * with_room(std::max(1, size.height)),
                                   width / aspect(size) * with_room(std::max(1, size.width))) /
                          2;
    Camera result = camera;
    result.focal_point = (bounds.low + bounds.high) / 2;
    result.half_height = half > smallest_half_height ? std::max(margin * half, needed) : 1.0;
    return result;
}

Camera view_of(const SceneBounds& bounds, StandardView view, PictureSize size, double room) {
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    switch (view) {
        case StandardView::top:
            return fitted(looking_along(-z, Eigen::Vector3d::UnitY()), bounds, size, room);
        case StandardView::front:
            return fitted(looking_along(Eigen::Vector3d::UnitY(), z), bounds, size, room);
        case StandardView::right:
            return fitted(looking_along(-Eigen::Vector3d::UnitX(), z), bounds, size, room);
        case StandardView::iso:
            break;
    }
    // Not quite isometric: from 25 degrees right of front, so that equal triangles do not fall on a line.
    return fitted(looking_along({-0.62, 1.0, -0.52}, z), bounds, size, room);
}

bool far_side_is_high(const Camera& camera, int axis) {
    constexpr double edge_on = 1e-6;
    return camera.direction[axis] > (axis == 2 ? edge_on : -edge_on);
}

Camera orbited(const Camera& camera, PictureSize size, double dx, double dy) {
    const double turn = 2 * std::numbers::pi / std::max(1, size.width);
    const double elevation = std::asin(std::clamp(-camera.direction.z(), -1.0, 1.0));
    const double limit = std::numbers::pi / 2;
    const double raise = std::clamp(elevation + dy * turn, -limit, limit) - elevation;
    const Eigen::Matrix3d R = (Eigen::AngleAxisd(-dx * turn, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(-raise, camera.right().normalized()))
                                  .toRotationMatrix();
    Camera result = camera;
    result.direction = (R * camera.direction).normalized();
    const Eigen::Vector3d up = R * camera.up;
    result.up = (up - up.dot(result.direction) * result.direction).normalized();
    return result;
}

Camera panned(const Camera& camera, PictureSize size, double dx, double dy) {
    const double scale = metres_per_pixel(camera, size);
    Camera result = camera;
    result.focal_point += scale * (dy * camera.up - dx * camera.right());
    return result;
}

Camera zoomed(const Camera& camera, double factor) {
    Camera result = camera;
    if (factor > 0)
        result.half_height =
            std::clamp(camera.half_height / factor, smallest_half_height, largest_half_height);
    return result;
}

}  // namespace covaria
