// Projection: standard views, fit, orbit, pan, zoom.
#include "viz/scene/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/project/saved_view.h"

namespace covaria {
namespace {

constexpr double smallest_half_height = 1e-9;
constexpr double largest_half_height = 1e9;
constexpr double tangent_of_view = 0.26794919243112270;  // tangent of 15 degrees
constexpr double nearest_to_eye = 1e-3;                  // part of the eye's distance from the focal point

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
    const auto& names = standard_view_names();
    const auto found = std::find(names.begin(), names.end(), key);
    if (found == names.end()) return std::nullopt;
    return static_cast<StandardView>(found - names.begin());
}

ViewDirections directions_of(StandardView view) {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                          z = Eigen::Vector3d::UnitZ();
    switch (view) {
        case StandardView::top:
            return {-z, y};
        case StandardView::front:
            return {y, z};
        case StandardView::right:
            return {-x, z};
        case StandardView::bottom:
            return {z, -y};
        case StandardView::back:
            return {-y, z};
        case StandardView::left:
            return {x, z};
        case StandardView::iso:
            break;
    }
    // The view is not quite isometric: 25 degrees right of front keep equal triangles from falling on a line.
    return {{-0.62, 1.0, -0.52}, z};
}

double Camera::eye_distance() const {
    return half_height / tangent_of_view;
}

double metres_per_pixel(const Camera& camera, PictureSize size) {
    return 2 * camera.half_height / std::max(1, size.height);
}

double metres_per_pixel(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W) {
    if (!camera.perspective) return metres_per_pixel(camera, size);
    const double eye = camera.eye_distance(), depth = (p_W - camera.focal_point).dot(camera.direction);
    return metres_per_pixel(camera, size) * std::max(nearest_to_eye, 1 + depth / eye);
}

Pixel project(const Camera& camera, PictureSize size, const Eigen::Vector3d& p_W) {
    const Eigen::Vector3d d = p_W - camera.focal_point;
    const double scale = 1 / metres_per_pixel(camera, size, p_W);
    return {size.width / 2.0 + scale * d.dot(camera.right()), size.height / 2.0 - scale * d.dot(camera.up)};
}

Eigen::Vector3d world_at(const Camera& camera, PictureSize size, Pixel pixel,
                         const Eigen::Vector3d& through_W) {
    const double scale = metres_per_pixel(camera, size, through_W);
    const double depth = (through_W - camera.focal_point).dot(camera.direction);
    return camera.focal_point + scale * (pixel.x - size.width / 2.0) * camera.right() -
           scale * (pixel.y - size.height / 2.0) * camera.up + depth * camera.direction;
}

Ray ray_through(const Camera& camera, PictureSize size, Pixel pixel) {
    const Eigen::Vector3d at = world_at(camera, size, pixel, camera.focal_point);
    if (!camera.perspective) return {at, camera.direction};
    const Eigen::Vector3d eye = camera.focal_point - camera.eye_distance() * camera.direction;
    return {at, (at - eye).normalized()};
}

std::array<Eigen::Vector3d, 8> corners_of(const SceneBounds& bounds) {
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? bounds.high.x() : bounds.low.x(), i & 2 ? bounds.high.y() : bounds.low.y(),
                      i & 4 ? bounds.high.z() : bounds.low.z()};
    return corners;
}

Camera fitted(const Camera& camera, const SceneBounds& bounds, PictureSize size, double room) {
    static constexpr double margin = 1.17;  // room for the axis titles, the title line and the caption
    const auto room_for = [room](double pixels) {
        return std::max(margin, pixels / (pixels - 2 * std::min(room, pixels / 4)));
    };
    const double for_height = room_for(std::max(1, size.height)),
                 for_width = room_for(std::max(1, size.width));
    Camera result = camera;
    result.focal_point = (bounds.low + bounds.high) / 2;
    result.half_height = 0.0;
    for (const Eigen::Vector3d& corner : corners_of(bounds)) {
        const Eigen::Vector3d d = corner - result.focal_point;
        // A perspective draws nearer things larger.
        const double nearer = camera.perspective ? -tangent_of_view * d.dot(camera.direction) : 0.0;
        const double half = std::max(for_height * std::abs(d.dot(camera.up)),
                                     for_width * std::abs(d.dot(camera.right())) / aspect(size));
        result.half_height = std::max(result.half_height, half + nearer);
    }
    if (result.half_height <= smallest_half_height) result.half_height = 1.0;
    return result;
}

Camera view_of(const SceneBounds& bounds, StandardView view, PictureSize size, double room,
               bool perspective) {
    const ViewDirections directions = directions_of(view);
    Camera camera = looking_along(directions.direction, directions.up);
    camera.perspective = perspective;
    return fitted(camera, bounds, size, room);
}

Camera with_foot(const Camera& camera, PictureSize size, int foot) {
    const PictureSize taller{size.width, size.height + foot};
    Camera result = camera;
    result.half_height *= static_cast<double>(taller.height) / std::max(1, size.height);
    return panned(result, taller, 0.0, -foot / 2.0);
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

Camera zoomed(const Camera& camera, double factor, PictureSize size, Pixel about) {
    Camera result = zoomed(camera, factor);
    const Eigen::Vector3d p_W = world_at(camera, size, about, camera.focal_point);
    result.focal_point = p_W + result.half_height / camera.half_height * (camera.focal_point - p_W);
    return result;
}

}  // namespace covaria
