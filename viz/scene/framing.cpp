#include "viz/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "viz/scene/solids.h"

namespace covaria {
namespace {

/// Whether each item is in the picture, by its id.
std::map<std::string, bool> items_in_picture(const Scene& scene, const Camera& camera, PictureSize size) {
    std::map<std::string, bool> seen;
    const auto add = [&](const auto& items) {
        for (const auto& each : items) {
            const Pixel at = project(camera, size, each.item.position);
            seen[each.item.id] = at.x >= 0 && at.y >= 0 && at.x <= size.width && at.y <= size.height;
        }
    };
    add(scene.points);
    add(scene.frames);
    add(scene.bodies);
    add(scene.vectors);
    return seen;
}

/// Whether an item is out of the picture now, and not for a turn of the camera.
bool has_left(const std::pair<const std::string, bool>& item, const std::map<std::string, bool>& before) {
    const auto found = before.find(item.first);
    return !item.second && (found == before.end() || found->second);
}

/// Extent of things across the picture and up it, m.
class Extent {
public:
    explicit Extent(const Camera& camera) : right_(camera.right()), up_(camera.up) {}

    void add(const Eigen::Vector3d& p, double across, double upright) {
        const double u = right_.dot(p), v = up_.dot(p);
        low_ = low_.cwiseMin(Eigen::Vector2d(u - across, v - upright));
        high_ = high_.cwiseMax(Eigen::Vector2d(u + across, v + upright));
    }
    void add(const Eigen::Vector3d& p, double radius = 0.0) { add(p, radius, radius); }
    void add(const SceneEllipsoid& e) {
        add(e.item.position, (e.axes.transpose() * right_).norm(), (e.axes.transpose() * up_).norm());
    }
    void add(const std::vector<Solid>& solids) {
        for (const Solid& solid : solids) {
            for (const Eigen::Vector3d& corner : solid.outline) add(corner, solid.thickness / 2);
            if (!solid.outline.empty()) continue;
            const double half = solid.edges.norm() / 2;
            add(solid.from, half + solid.from_radius);
            add(solid.to, half + solid.to_radius);
        }
    }
    bool is_empty() const { return !(low_.array() <= high_.array()).all(); }

    Camera filling(const Camera& camera, PictureSize size, const ScreenRect& inside) const {
        const Eigen::Vector2d extent = high_ - low_, middle = (low_ + high_) / 2;
        const double scale = std::max(
            {extent.x() / std::max(1.0, inside.width), extent.y() / std::max(1.0, inside.height), 1e-12});
        const double dx = inside.x + inside.width / 2 - size.width / 2.0,
                     dy = inside.y + inside.height / 2 - size.height / 2.0;
        Camera result = camera;
        result.half_height = scale * size.height / 2;
        result.focal_point += (middle.x() - scale * dx - right_.dot(camera.focal_point)) * right_ +
                              (middle.y() + scale * dy - up_.dot(camera.focal_point)) * up_;
        return result;
    }

private:
    static constexpr double far_ = std::numeric_limits<double>::infinity();
    Eigen::Vector3d right_, up_;
    Eigen::Vector2d low_ = Eigen::Vector2d::Constant(far_), high_ = Eigen::Vector2d::Constant(-far_);
};

void add_scene(const Scene& scene, Extent& extent) {
    extent.add(solids_of_bodies(scene));
    extent.add(solids_of_links(scene));
    extent.add(solids_of_points(scene));
    for (const SceneFrame& frame : scene.frames) extent.add(frame.item.position);
    for (const SceneLink& link : scene.links) {
        extent.add(link.from);
        extent.add(link.to);
    }
    for (const SceneVector& vector : scene.vectors) {
        extent.add(vector.item.position);
        extent.add(vector.item.position + vector.arrow);
    }
    for (const auto* ellipsoids : {&scene.ellipsoids, &scene.ellipsoids_before})
        for (const SceneEllipsoid& ellipsoid : *ellipsoids) extent.add(ellipsoid);
    for (const SceneWallHistogram& wall : scene.wall_histograms) {
        extent.add(wall.low);
        extent.add(wall.high);
    }
    if (!scene.map) return;
    for (std::size_t i = 0; i < scene.map->positions.size(); ++i)
        if (std::isfinite(scene.map->values[i])) extent.add(scene.map->positions[i], scene.map->radius);
}

}  // namespace

Camera filling(const Camera& camera, const Scene& scene, PictureSize size, const ScreenRect& inside) {
    Extent extent(camera);
    add_scene(scene, extent);
    return extent.is_empty() ? filling(camera, bounds_of(scene), size, inside)
                             : extent.filling(camera, size, inside);
}

Camera filling(const Camera& camera, const SceneBounds& bounds, PictureSize size, const ScreenRect& inside) {
    Extent extent(camera);
    for (const Eigen::Vector3d& corner : corners_of(bounds)) extent.add(corner);
    return extent.filling(camera, size, inside);
}

Framing::Judgement Framing::next(std::shared_ptr<const Scene> scene, bool framed, bool held) {
    const bool other = !before_ || before_->title != scene->title;
    if (other) explained_ = 0;
    const bool explains_more = scene->legend.size() > explained_;
    explained_ = std::max(explained_, scene->legend.size());
    if (held) return [](const Camera&, PictureSize) { return false; };
    const auto before = std::exchange(before_, scene);
    if (framed && (other || explains_more)) return [](const Camera&, PictureSize) { return true; };
    return [=](const Camera& camera, PictureSize size) {
        const auto now = items_in_picture(*scene, camera, size);
        const auto earlier = before ? items_in_picture(*before, camera, size) : std::map<std::string, bool>{};
        if (framed)
            return std::ranges::any_of(now, [&](const auto& item) { return has_left(item, earlier); });
        const auto is_seen = [](const auto& item) { return item.second; };
        return !now.empty() && std::ranges::none_of(now, is_seen) &&
               (other || std::ranges::any_of(earlier, is_seen));
    };
}

}  // namespace covaria
