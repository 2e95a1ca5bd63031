#include "viz/scene/handles.h"

#include <Eigen/Geometry>
#include <cmath>

#include "viz/scene/pick.h"

namespace covaria {
namespace {

double distance(Pixel a, Pixel b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

bool is_pose(const LayoutSource& source) {
    return source.draggable && source.path.find("/rows/") == std::string::npos;
}

/// Axes of an instrument have no name of their own.
SceneItem named(SceneItem item) {
    if (item.name.empty()) item.name = item.id.substr(item.id.find(':') + 1);
    return item;
}

std::optional<Handle> tip_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                             double reach) {
    std::optional<Handle> nearest;
    for (const SceneFrame& frame : scene.frames) {
        if (!is_pose(frame.item.source)) continue;
        const Pixel origin = project(camera, size, frame.item.position);
        for (int i = 0; i < 3; ++i) {
            const Pixel tip = project(camera, size, frame.item.position + frame.length * frame.R_WF.col(i));
            // An axis that points at the eye hides its own origin.
            if (distance(tip, origin) < 2 * reach || distance(tip, pixel) > reach) continue;
            reach = distance(tip, pixel);
            nearest = Handle{named(frame.item), frame, i};
        }
    }
    return nearest;
}

bool is_grasped(const SceneItem* item, const Camera& camera, PictureSize size, Pixel pixel, double reach) {
    return item && item->source.draggable && distance(project(camera, size, item->position), pixel) < reach;
}

/// The direction from the origin to what is under the pixel, in the plane across `axis`.
Eigen::Vector3d direction_in_plane(const Camera& camera, PictureSize size, Pixel pixel,
                                   const Eigen::Vector3d& origin, const Eigen::Vector3d& axis) {
    const Ray ray = ray_through(camera, size, pixel);
    const double along = (origin - ray.origin).dot(axis) / ray.direction.dot(axis);
    return ray.origin + along * ray.direction - origin;
}

}  // namespace

std::optional<Handle> handle_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                const std::function<bool(Layer)>& shown, const std::string& preferred,
                                double reach) {
    const SceneItem* selected = find_item(scene, preferred);
    if (is_grasped(selected, camera, size, pixel, reach)) return Handle{named(*selected)};
    if (shown(Layer::frames))
        if (auto tip = tip_at(scene, camera, size, pixel, 0.7 * reach)) return tip;
    const auto picked = pick_item(scene, camera, size, pixel, shown, 0.5 * reach);
    const SceneItem* item = picked ? find_item(scene, *picked) : nullptr;
    if (is_grasped(item, camera, size, pixel, reach)) return Handle{named(*item)};
    return std::nullopt;
}

Eigen::Matrix3d turn_by(const Handle& handle, const Camera& camera, PictureSize size, Pixel from, Pixel to,
                        double step) {
    const SceneFrame& frame = *handle.frame;
    Eigen::Vector3d axis = frame.R_WF.col((handle.tip + 1) % 3);
    const Eigen::Vector3d other = frame.R_WF.col((handle.tip + 2) % 3);
    if (std::abs(other.dot(camera.direction)) > std::abs(axis.dot(camera.direction))) axis = other;
    const Eigen::Vector3d& origin = frame.item.position;
    const Eigen::Vector3d a = direction_in_plane(camera, size, from, origin, axis),
                          b = direction_in_plane(camera, size, to, origin, axis);
    double angle = std::atan2(axis.dot(a.cross(b)), a.dot(b));
    if (step > 0) angle = step * std::round(angle / step);
    if (!std::isfinite(angle)) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Eigen::Vector3d snapped(const SceneItem& item, const Eigen::Vector3d& p_W, double step) {
    const Eigen::Isometry3d X_SW = item.source.X_WS.inverse();
    const Eigen::Vector3d before = X_SW * item.position;
    Eigen::Vector3d p = X_SW * p_W;
    for (int i = 0; i < 3; ++i)
        p[i] = std::abs(p[i] - before[i]) < 0.5 * step ? before[i] : step * std::round(p[i] / step);
    return item.source.X_WS * p;
}

}  // namespace covaria
