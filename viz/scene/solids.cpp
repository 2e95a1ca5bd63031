#include "viz/scene/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace covaria {
namespace {

using Vector = Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

Solid round(const Vector& from, const Vector& to, double from_radius, double to_radius, double bevel,
            Material material) {
    Solid solid;
    solid.material = material;
    solid.from = from;
    solid.to = to;
    solid.from_radius = from_radius;
    solid.to_radius = to_radius;
    solid.bevel = bevel;
    return solid;
}

Solid disc(const Vector& from, const Vector& to, double radius, Material material) {
    return round(from, to, radius, radius, std::min(0.25 * (to - from).norm(), 0.2 * radius), material);
}

/// A round solid that reaches beyond both points by its radii, with round ends.
Solid capsule(const Vector& from, const Vector& to, double from_radius, double to_radius, Material material) {
    const Vector way = to - from;
    const Vector along = way.norm() > 0 ? Vector(way.normalized()) : Vector::UnitZ();
    return round(from - from_radius * along, to + to_radius * along, from_radius, to_radius,
                 std::max(from_radius, to_radius), material);
}

Solid ball(const Vector& centre, double radius, Material material) {
    return capsule(centre, centre, radius, radius, material);
}

Solid box(const Vector& centre, const Eigen::Matrix3d& R, const Vector& edges, double bevel,
          Material material) {
    Solid solid;
    solid.shape = Solid::Shape::box;
    solid.material = material;
    solid.from = solid.to = centre;
    solid.R = R;
    solid.edges = edges;
    solid.bevel = bevel;
    return solid;
}

/// An instrument: what turns in azimuth with its target, and what it stands on.
class Instrument {
public:
    Instrument(const SceneBody& body, double floor, std::vector<Solid>& into)
        : body_(body), s_(body.size), floor_(floor), p_(body.item.position), into_(into) {
        up_ = body.R_WB.col(2);
        sight_ = body.sight.norm() > 0 ? body.sight : Vector(body.R_WB.col(0));
        Vector ahead = sight_ - sight_.dot(up_) * up_;
        ahead = ahead.norm() > 1e-6 ? Vector(ahead.normalized()) : Vector(body.R_WB.col(0));
        turned_ << ahead, up_.cross(ahead), up_;
    }

    void add() {
        if (body_.kind == BodyKind::force_sensor) return add_force_sensor();
        if (body_.glyph == "camera") return add_camera();
        if (body_.glyph == "distance-meter") {
            add_distance_meter();
        } else if (body_.glyph == "tracker") {
            add_fork(0.62);
            add_tracker_head();
        } else {
            add_fork(0.66);
            add_telescope();
        }
        add_stand();
    }

private:
    Vector at(double ahead, double across, double above) const {
        return p_ + s_ * (turned_ * Vector(ahead, across, above));
    }
    Vector along(double part) const { return p_ + s_ * part * sight_; }

    void add_force_sensor() {
        into_.push_back(disc(p_ - 0.13 * s_ * up_, p_ + 0.13 * s_ * up_, 0.34 * s_, Material::part));
        for (const double side : {-1.0, 1.0})
            into_.push_back(
                disc(p_ + side * 0.13 * s_ * up_, p_ + side * 0.2 * s_ * up_, 0.24 * s_, Material::dark));
    }

    void add_camera() {
        const Eigen::Matrix3d& R = body_.R_WB;
        const Vector back = p_ - 0.16 * s_ * R.col(0);
        into_.push_back(box(back, R, s_ * Vector(0.34, 0.46, 0.36), 0.05 * s_, Material::instrument));
        into_.push_back(disc(p_, p_ + 0.16 * s_ * R.col(0), 0.15 * s_, Material::dark));
        into_.push_back(
            disc(p_ + 0.13 * s_ * R.col(0), p_ + 0.175 * s_ * R.col(0), 0.11 * s_, Material::lens));
    }

    void add_distance_meter() {
        into_.push_back(
            box(at(-0.26, 0, 0), turned_, s_ * Vector(0.56, 0.28, 0.26), 0.05 * s_, Material::instrument));
        into_.push_back(disc(at(0.0, 0, 0), at(0.07, 0, 0), 0.09 * s_, Material::dark));
        into_.push_back(disc(at(-0.26, 0, -0.5), at(-0.26, 0, -0.13), 0.1 * s_, Material::dark));
    }

    /// Adds two uprights on a turning base.
    void add_fork(double height) {
        for (const double side : {-1.0, 1.0})
            into_.push_back(box(at(0, side * 0.235, 0.3 - height / 2), turned_,
                                s_ * Vector(0.27, 0.12, height), 0.05 * s_, Material::instrument));
        into_.push_back(
            box(at(0, 0, -0.36), turned_, s_ * Vector(0.32, 0.58, 0.13), 0.05 * s_, Material::instrument));
        into_.push_back(disc(at(0, 0, -0.66), at(0, 0, -0.42), 0.25 * s_, Material::instrument));
    }

    void add_tracker_head() {
        into_.push_back(ball(p_, 0.165 * s_, Material::dark));
        into_.push_back(disc(along(-0.04), along(0.21), 0.115 * s_, Material::dark));
        into_.push_back(disc(along(0.19), along(0.222), 0.075 * s_, Material::lens));
    }

    void add_telescope() {
        into_.push_back(
            box(at(0, 0, 0.36), turned_, s_ * Vector(0.12, 0.58, 0.07), 0.03 * s_, Material::dark));
        into_.push_back(round(along(-0.24), along(0.2), 0.08 * s_, 0.1 * s_, 0.02 * s_, Material::dark));
        into_.push_back(disc(along(0.18), along(0.225), 0.085 * s_, Material::lens));
        into_.push_back(ball(p_, 0.15 * s_, Material::dark));
    }

    /// Adds a tripod, or a foot where there is no room for one; nothing below an instrument that hangs askew.
    void add_stand() {
        if (up_.z() < 0.8) return;
        const Vector head = at(0, 0, -0.66);
        const double height = head.z() - floor_;
        const Vector ground(head.x(), head.y(), floor_);
        into_.push_back(disc(head - 0.08 * s_ * Vector::UnitZ(), head, 0.2 * s_, Material::dark));
        if (height < 0.9 * s_) {
            if (height > 0.1 * s_)
                into_.push_back(round(ground, head - 0.08 * s_ * Vector::UnitZ(), 0.24 * s_, 0.16 * s_,
                                      0.03 * s_, Material::leg));
            return;
        }
        const Vector top = head - 0.1 * s_ * Vector::UnitZ();
        const double spread = std::min(0.36 * height, 1.3 * s_);
        into_.push_back(
            disc(top - std::min(0.3 * height, 0.7 * s_) * Vector::UnitZ(), top, 0.06 * s_, Material::leg));
        for (int leg = 0; leg < 3; ++leg) {
            const double angle = (0.5 + 2.0 * leg / 3.0) * pi + 0.3;
            const Vector out = turned_ * Vector(std::cos(angle), std::sin(angle), 0.0);
            const Vector foot = ground + spread * out + 0.03 * s_ * Vector::UnitZ();
            into_.push_back(capsule(top + 0.11 * s_ * out, top + 0.52 * (foot - top), 0.055 * s_, 0.05 * s_,
                                    Material::leg));
            into_.push_back(capsule(top + 0.45 * (foot - top), foot, 0.034 * s_, 0.028 * s_, Material::leg));
            into_.push_back(disc(foot - 0.03 * s_ * Vector::UnitZ(), foot + 0.03 * s_ * Vector::UnitZ(),
                                 0.08 * s_, Material::dark));
        }
    }

    const SceneBody& body_;
    double s_, floor_;
    Vector p_, up_, sight_;
    Eigen::Matrix3d turned_;
    std::vector<Solid>& into_;
};

void add_plate(const SceneBody& body, std::vector<Solid>& into) {
    Solid plate;
    plate.shape = Solid::Shape::prism;
    plate.material = body.kind == BodyKind::artefact ? Material::part : Material::plate;
    plate.outline = body.outline;
    plate.normal = body.normal;
    plate.thickness = body.thickness;
    plate.bevel = 0.12 * body.thickness;
    for (const Vector& corner : body.outline) plate.from += corner / static_cast<double>(body.outline.size());
    plate.to = plate.from;
    plate.opacity = body.encloses ? 0.3 : 1.0;
    if (body.feet > 0) {
        // Four corners as far from each other as they are; a triangle has three.
        const Vector middle = plate.from - body.thickness / 2 * body.normal;
        const std::size_t n = body.outline.size(), feet = std::min<std::size_t>(body.corners, 4);
        for (std::size_t i = 0; i < feet; ++i) {
            const std::size_t k = (i * n / feet + n / (2 * feet)) % n;
            const Vector corner = body.outline[k] - body.thickness / 2 * body.normal;
            const Vector top = corner + 0.16 * (middle - corner);
            into.push_back(round(top - body.feet * body.normal, top, 1.1 * body.feet * 0.6,
                                 1.1 * body.feet * 0.6, 0.08 * body.feet, Material::support));
        }
    }
    into.push_back(std::move(plate));
}

/// A ring round an axis, with lighter lids.
void add_drum(const SceneLink& joint, std::vector<Solid>& into) {
    const Vector middle = (joint.from + joint.to) / 2, half = (joint.to - joint.from) / 2;
    into.push_back(round(middle - 0.94 * half, middle + 0.94 * half, joint.radius, joint.radius,
                         0.12 * joint.radius, Material::joint));
    into.push_back(round(middle - half, middle + half, 0.72 * joint.radius, 0.72 * joint.radius,
                         0.06 * joint.radius, Material::robot));
}

}  // namespace

std::vector<Solid> solids_of_bodies(const Scene& scene) {
    std::vector<Solid> solids;
    const double floor = scene.floor.value_or(-std::numeric_limits<double>::infinity());
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty())
            Instrument(body, floor, solids).add();
        else
            add_plate(body, solids);
    return solids;
}

std::vector<Solid> solids_of_links(const Scene& scene) {
    std::vector<Solid> solids;
    for (const SceneLink& link : scene.links) {
        if (!(link.radius > 0)) continue;
        const double r = link.radius, end = link.end_radius > 0 ? link.end_radius : r;
        const Vector way = link.to - link.from;
        if (!(way.norm() > 0)) continue;
        switch (link.kind) {
            case LinkKind::joint_axis:
                add_drum(link, solids);
                break;
            case LinkKind::robot_link:
                solids.push_back(capsule(link.from, link.to, r, end, Material::robot));
                if (link.stands) {
                    const Vector up = way.normalized();
                    const Vector ground = link.from - link.foot * up;
                    solids.push_back(disc(ground, ground + 0.28 * r * up, 1.55 * r, Material::robot));
                    solids.push_back(
                        round(ground, link.from + 0.6 * r * up, 1.3 * r, 1.12 * r, 0.1 * r, Material::robot));
                }
                break;
            case LinkKind::leg:  // a cylinder and the rod that comes out of it
                solids.push_back(
                    round(link.from, link.from + 0.58 * way, r, r, 0.15 * r, Material::instrument));
                solids.push_back(
                    round(link.from + 0.5 * way, link.to, 0.6 * r, 0.6 * r, 0.1 * r, Material::leg));
                break;
            default:  // a bar between two balls
                solids.push_back(round(link.from, link.to, 0.62 * r, 0.62 * r, 0.1 * r, Material::joint));
                solids.push_back(
                    round(link.from + 0.08 * way, link.to - 0.08 * way, r, r, 0.3 * r, Material::dark));
        }
    }
    return solids;
}

std::vector<Solid> solids_of_points(const Scene& scene) {
    std::set<std::string> instruments;
    for (const SceneBody& body : scene.bodies)
        if (body.outline.empty()) instruments.insert(body.item.id);
    std::vector<Solid> solids;
    for (const ScenePoint& point : scene.points) {
        const Vector &p = point.item.position, &up = point.axis;
        const double r = point.radius;
        switch (point.kind) {
            case PointKind::nest:
                solids.push_back(ball(p, r, Material::nest));
                solids.push_back(
                    round(p - 0.75 * r * up, p - 0.2 * r * up, 1.25 * r, 1.0 * r, 0.15 * r, Material::joint));
                break;
            case PointKind::support:
                solids.push_back(
                    round(p - 2.2 * r * up, p - 0.5 * r * up, 1.3 * r, 0.7 * r, 0.15 * r, Material::joint));
                solids.push_back(ball(p, 0.8 * r, Material::nest));
                break;
            case PointKind::flange:
                solids.push_back(disc(p - 0.35 * r * up, p + 0.35 * r * up, 1.8 * r, Material::joint));
                break;
            case PointKind::tool:
                solids.push_back(ball(p, 0.6 * r, Material::joint));
                break;
            case PointKind::station:
                if (!instruments.contains(point.item.body)) solids.push_back(ball(p, r, Material::joint));
                break;
            default:
                solids.push_back(ball(p, r, Material::nest));
        }
    }
    return solids;
}

double lowest_of(const Scene& scene) {
    constexpr double below_head = 0.76;  // part of an instrument's size: its base and what carries it
    double lowest = std::numeric_limits<double>::infinity();
    for (const SceneBody& body : scene.bodies) {
        if (body.outline.empty()) lowest = std::min(lowest, body.item.position.z() - below_head * body.size);
        for (const Vector& corner : body.outline)
            lowest = std::min(lowest, corner.z() - body.thickness / 2 * std::abs(body.normal.z()) -
                                          body.feet * body.normal.z());
    }
    for (const SceneLink& link : scene.links) {
        if (!(link.radius > 0)) continue;
        const double foot = link.stands ? link.foot : link.radius;
        lowest = std::min({lowest, link.from.z() - foot, link.to.z() - link.radius});
    }
    for (const ScenePoint& point : scene.points)
        lowest = std::min(lowest, point.item.position.z() - point.radius);
    return lowest;
}

double lowest_uncertainty_of(const Scene& scene) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const SceneEllipsoid& ellipsoid : scene.ellipsoids)
        lowest = std::min(lowest, ellipsoid.item.position.z() - ellipsoid.axes.row(2).norm());
    for (const SceneCloud& cloud : scene.clouds)
        for (std::size_t i = 0; i < cloud.size(); ++i) lowest = std::min(lowest, cloud.dot(i).z());
    return lowest;
}

}  // namespace covaria
