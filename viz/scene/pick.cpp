// Picking by geometry: the ray of a pixel against points, segments, ellipsoids and outlines.
#include "viz/scene/pick.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "viz/scene/section.h"

namespace covaria {
namespace {

/// Scene coordinates of the picture: x to the right and y up in pixels, z away from the eye in metres.
class View {
public:
    View(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel)
        : scene_(scene),
          camera_(camera),
          size_(size),
          pixel_(pixel),
          ray_(ray_through(camera, size, pixel)),
          seen_(part_seen()) {}

    Eigen::Vector2d offset(const Eigen::Vector3d& p) const {
        const Pixel at = project(camera_, size_, p);
        return {at.x - pixel_.x, at.y - pixel_.y};
    }
    double depth(const Eigen::Vector3d& p) const { return (p - camera_.focal_point).dot(camera_.direction); }
    /// Pixels of a length at a place.
    double pixels(double metres, const Eigen::Vector3d& p) const {
        return metres / metres_per_pixel(camera_, size_, p);
    }
    const Eigen::Vector3d& origin() const { return ray_.origin; }
    const Eigen::Vector3d& direction() const { return ray_.direction; }
    /// Where along the ray a thing comes into view that is on it from `enters` to `leaves`: at the plane of a
    /// section, maybe; nullopt: it is cut away there.
    std::optional<double> first_seen(double enters, double leaves) const {
        const double first = std::max(enters, seen_[0]);
        return first <= std::min(leaves, seen_[1]) ? std::optional(first) : std::nullopt;
    }
    bool is_cut_away(const Eigen::Vector3d& p) const { return covaria::is_cut_away(scene_, p); }
    /// The place on the ray that is nearest to `p`.
    Eigen::Vector3d on_ray(const Eigen::Vector3d& p) const {
        return ray_.origin + (p - ray_.origin).dot(ray_.direction) * ray_.direction;
    }

    /// Distance in pixels from the pixel to the projected segment, and the depth of the nearest place; far
    /// where the segment is cut away.
    std::pair<double, double> to_segment(const Eigen::Vector3d& begin, const Eigen::Vector3d& end) const {
        const auto left = left_of_line(scene_, begin, end);
        if (!left) return {far_, far_};
        const auto& [from, to] = *left;
        const Eigen::Vector2d a = offset(from), d = offset(to) - a;
        const double t = d.squaredNorm() > 0 ? std::clamp(-a.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
        return {(a + t * d).norm(), depth(from + t * (to - from))};
    }

private:
    static constexpr double far_ = std::numeric_limits<double>::infinity();
    /// Begin and end of the part of the ray that is not cut away.
    std::array<double, 2> part_seen() const {
        if (!scene_.section) return {-far_, far_};
        const double deep = scene_.section->depth_of(ray_.origin);
        const double deeper = scene_.section->depth_of(ray_.origin + ray_.direction) - deep;
        if (deeper == 0.0) return deep > 0.0 ? std::array{far_, -far_} : std::array{-far_, far_};
        return deeper > 0.0 ? std::array{-far_, -deep / deeper} : std::array{-deep / deeper, far_};
    }

    const Scene& scene_;
    Camera camera_;
    PictureSize size_;
    Pixel pixel_;
    Ray ray_;
    std::array<double, 2> seen_;
};

/// Keeps the item of the best rank that the pixel lies on or least beside, then the one nearest to the eye.
class Best {
public:
    /// `aside`: pixels from the pixel to what is drawn of the item.
    void offer(int rank, double aside, double depth, const std::string& id) {
        const std::tuple place{rank, std::max(0.0, aside), depth};
        if (id_ && place >= place_) return;
        place_ = place;
        id_ = id;
    }
    const std::optional<std::string>& id() const { return id_; }

private:
    std::tuple<int, double, double> place_;
    std::optional<std::string> id_;
};

/// Where along the ray { centre + axes s, |s| <= 1 } is seen; thin ellipsoids are taken 1 % thick.
std::optional<double> meets(const View& view, const SceneEllipsoid& ellipsoid) {
    Eigen::Matrix3d axes = ellipsoid.axes;
    const double thick = 0.01 * axes.col(0).norm();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(axes, Eigen::ComputeFullU);
    axes = svd.matrixU() * svd.singularValues().cwiseMax(thick).asDiagonal();
    const Eigen::Matrix3d inverse = axes.inverse();
    const Eigen::Vector3d o = inverse * (view.origin() - ellipsoid.item.position);
    const Eigen::Vector3d d = inverse * view.direction();
    const double b = o.dot(d), a = d.squaredNorm();
    const double root = b * b - a * (o.squaredNorm() - 1);
    if (!(root >= 0)) return std::nullopt;
    return view.first_seen((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
}

bool inside(const View& view, const std::vector<Eigen::Vector3d>& outline) {
    bool in = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Eigen::Vector2d a = view.offset(outline[i]), b = view.offset(outline[j]);
        if ((a.y() > 0) != (b.y() > 0) && 0 < (b.x() - a.x()) * (0 - a.y()) / (b.y() - a.y()) + a.x())
            in = !in;
    }
    return in;
}

/// The place of a plate that is under the pixel.
Eigen::Vector3d place_in_plane(const View& view, const SceneBody& body) {
    const double along = view.direction().dot(body.normal);
    if (std::abs(along) < 1e-9) return body.item.position;
    return view.origin() + (body.item.position - view.origin()).dot(body.normal) / along * view.direction();
}

void offer_bodies(const Scene& scene, const View& view, Best& best) {
    for (const SceneBody& body : scene.bodies) {
        const bool is_plate = !body.outline.empty();
        const Eigen::Vector3d& middle = body.item.position;
        const bool is_there = is_plate ? inside(view, body.outline)
                                       : view.offset(middle).norm() <= view.pixels(body.size / 2, middle);
        if (!is_there || view.is_cut_away(is_plate ? place_in_plane(view, body) : view.on_ray(middle)))
            continue;
        best.offer(is_plate ? 6 : 4, 0.0, view.depth(is_plate ? place_in_plane(view, body) : middle),
                   body.item.id);
    }
}

/// Depth at which the ray meets a triangle first (Möller and Trumbore, 1997), in the mesh's own frame.
std::optional<double> meets(const View& view, const SceneMesh& mesh) {
    const Eigen::Isometry3d X_MW = mesh.X_WM.inverse();
    const Eigen::Vector3f o = (X_MW * view.origin() / mesh.scale).cast<float>();
    const Eigen::Vector3f d = (X_MW.linear() * view.direction()).cast<float>();
    std::optional<float> nearest;
    const float* corner = mesh.triangles->corners.data();
    for (std::size_t i = 0; i < mesh.triangles->triangles(); ++i, corner += 9) {
        const Eigen::Map<const Eigen::Vector3f> a(corner), b(corner + 3), c(corner + 6);
        const Eigen::Vector3f e = b - a, f = c - a, p = d.cross(f), s = o - a;
        const float det = e.dot(p);
        const float u = s.dot(p) / det;
        if (!(u >= 0 && u <= 1)) continue;
        const Eigen::Vector3f q = s.cross(e);
        const float v = d.dot(q) / det;
        if (!(v >= 0 && u + v <= 1)) continue;
        const float t = f.dot(q) / det;
        const double way = mesh.scale * static_cast<double>(t);
        if ((!nearest || t < *nearest) && view.first_seen(way, way)) nearest = t;
    }
    if (!nearest) return std::nullopt;
    return view.depth(view.origin() + mesh.scale * static_cast<double>(*nearest) * view.direction());
}

}  // namespace

std::optional<std::string> pick_item(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                     const std::function<bool(Layer)>& shown, double reach) {
    const View view(scene, camera, size, pixel);
    Best best;
    if (shown(Layer::points))
        for (const ScenePoint& point : scene.points) {
            if (view.is_cut_away(point.item.position)) continue;
            const double away = view.offset(point.item.position).norm(),
                         radius = view.pixels(point.radius, point.item.position);
            if (away <= std::max(reach, radius))
                best.offer(0, away - radius, view.depth(point.item.position), point.item.id);
        }
    if (shown(Layer::frames))
        for (const SceneFrame& frame : scene.frames) {
            if (view.is_cut_away(frame.item.position)) continue;
            if (const double away = view.offset(frame.item.position).norm(); away <= reach)
                best.offer(1, away, view.depth(frame.item.position), frame.item.id);
            // A frame's axes are drawn while it is pointed at: other items that can be seen there come first.
            for (int i = 0; i < 3; ++i) {
                const auto [away, depth] = view.to_segment(
                    frame.item.position, frame.item.position + frame.length * frame.R_WF.col(i));
                if (away <= reach / 2) best.offer(7, away, depth, frame.item.id);
            }
        }
    if (shown(Layer::vectors))
        for (const SceneVector& vector : scene.vectors) {
            const auto [away, depth] =
                view.to_segment(vector.item.position, vector.item.position + vector.arrow);
            const double radius = view.pixels(vector.radius, vector.item.position);
            if (away <= std::max(reach, radius)) best.offer(2, away - radius, depth, vector.item.id);
        }
    if (shown(Layer::ellipsoids))
        for (const SceneEllipsoid& ellipsoid : scene.ellipsoids)
            if (const auto place = meets(view, ellipsoid)) best.offer(3, 0.0, *place, ellipsoid.item.id);
    if (shown(Layer::links))
        for (const SceneLink& link : scene.links) {
            const auto [away, depth] = view.to_segment(link.from, link.to);
            const double radius = view.pixels(link.radius, link.item.position);
            if (away <= std::max(reach / 2, radius)) best.offer(5, away - radius, depth, link.item.id);
        }
    if (shown(Layer::bodies)) offer_bodies(scene, view, best);
    if (!best.id() && shown(Layer::meshes))
        for (const SceneMesh& mesh : scene.meshes)
            if (const auto depth = meets(view, mesh)) best.offer(8, 0.0, *depth, mesh.item.id);
    return best.id();
}

}  // namespace covaria
