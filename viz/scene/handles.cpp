#include "viz/scene/handles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "viz/scene/pick.h"
#include "viz/scene/section.h"

namespace covaria {
namespace {

double distance(Pixel a, Pixel b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

bool is_pose(const LayoutSource& source) {
    return source.draggable && source.path.find("/rows/") == std::string::npos;
}

/// The item with a name for the list of undo steps.
SceneItem named(SceneItem item) {
    item.name = name_of(item);
    return item;
}

std::optional<Handle> tip_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                             double reach) {
    std::optional<Handle> nearest;
    for (const SceneFrame& frame : scene.frames) {
        if (!is_pose(frame.item.source) || is_cut_away(scene, frame.item.position)) continue;
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

constexpr double arrow_begins = 0.3, shortest_arrow = 0.25;  // parts of an arrow's length

/// Coordinate of the pointer along the axis through the item, m.
double along_axis(const Handle& arrow, const Camera& camera, PictureSize size, Pixel pixel) {
    const Ray ray = ray_through(camera, size, pixel);
    const Eigen::Vector3d axis = arrow.item.source.X_WS.linear().col(arrow.axis);
    const Eigen::Vector3d to_ray = ray.origin - arrow.item.position;
    const double cosine = axis.dot(ray.direction);
    return (to_ray.dot(axis) - cosine * to_ray.dot(ray.direction)) / (1.0 - cosine * cosine);
}

double distance_to(const HandleMarks::Arrow& arrow, Pixel pixel) {
    const Eigen::Vector2d from(arrow.from.x, arrow.from.y), to(arrow.to.x, arrow.to.y), at(pixel.x, pixel.y);
    const double t = (at - from).dot(to - from) / (to - from).squaredNorm();
    return (at - from - std::clamp(t, 0.0, 1.0) * (to - from)).norm();
}

}  // namespace

HandleMarks handle_marks(const Scene& scene, const Camera& camera, PictureSize size, const std::string& item,
                         double length) {
    HandleMarks marks;
    const SceneItem* found = find_item(scene, item);
    if (!found || !found->source.draggable) return marks;
    const double metres = length * metres_per_pixel(camera, size, found->position);
    const Pixel middle = project(camera, size, found->position);
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d axis = found->source.X_WS.linear().col(i);
        const Pixel to = project(camera, size, found->position + metres * axis);
        if (distance(middle, to) < shortest_arrow * length) continue;
        const Pixel from{middle.x + arrow_begins * (to.x - middle.x),
                         middle.y + arrow_begins * (to.y - middle.y)};
        marks.arrows.push_back({i, from, to});
    }
    for (const SceneFrame& frame : scene.frames)
        if (is_pose(frame.item.source) && stand_by_one_field(frame.item, *found))
            for (int i = 0; i < 3; ++i)
                marks.tips.push_back(
                    project(camera, size, frame.item.position + frame.length * frame.R_WF.col(i)));
    return marks;
}

std::optional<Handle> arrow_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                               const std::string& item, double length, double reach) {
    std::optional<Handle> nearest;
    for (const HandleMarks::Arrow& arrow : handle_marks(scene, camera, size, item, length).arrows)
        if (const double off = distance_to(arrow, pixel); off < reach) {
            reach = off;
            nearest = Handle{named(*find_item(scene, item)), {}, 0, arrow.axis};
        }
    return nearest;
}

Eigen::Vector3d moved_along(const Handle& arrow, const Camera& camera, PictureSize size, Pixel from,
                            Pixel to) {
    const double way = along_axis(arrow, camera, size, to) - along_axis(arrow, camera, size, from);
    if (!std::isfinite(way)) return arrow.item.position;
    return arrow.item.position + way * arrow.item.source.X_WS.linear().col(arrow.axis);
}

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

int turning_axis(const Handle& handle, const Camera& camera) {
    const int next = (handle.tip + 1) % 3, last = (handle.tip + 2) % 3;
    const auto towards_eye = [&](int axis) {
        return std::abs(handle.frame->R_WF.col(axis).dot(camera.direction));
    };
    return towards_eye(last) > towards_eye(next) ? last : next;
}

Eigen::Matrix3d turn_by(const Handle& handle, const Camera& camera, PictureSize size, Pixel from, Pixel to,
                        double step) {
    const SceneFrame& frame = *handle.frame;
    const Eigen::Vector3d axis = frame.R_WF.col(turning_axis(handle, camera));
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
