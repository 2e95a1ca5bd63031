#include "core/readers/comp3d_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace covaria {

namespace {

constexpr double u_of_middle = 1e-7;  ///< u of the middle of a circle off its plane, m

}  // namespace

void Comp3dAxes::take_all(Proposals& proposals) {
    std::size_t taken = 0;
    for (const Comp3dAxis& axis : survey_.axes) {
        const auto is_another = [&](const Comp3dAxis& other) {
            return &other != &axis && other.origin == axis.origin;
        };
        const bool one_target = std::ranges::all_of(axis.positions, [&](const Comp3dAxis::Position& p) {
            return p.target == axis.positions.front().target;
        });
        if (std::ranges::any_of(survey_.axes, is_another) || !one_target || !take(axis))
            files_.leave_out(axis.at, tell<"a rotation axis, %1: circles about an axis are not part of a "
                                           "network here">(axis.origin));
        else
            ++taken;
    }
    if (taken > 0)
        proposals.found.push_back(
            tell<
                "%1 rotation axes with one target each: the circle is a plane with a point in its middle, as "
                "far from all positions">(taken));
}

/// The circle through three positions, of which the first two are as far apart as any is from the first.
std::optional<Comp3dAxes::Circle> Comp3dAxes::circle_of(const Comp3dAxis& axis) const {
    std::vector<Eigen::Vector3d> places;
    for (const Comp3dAxis::Position& position : axis.positions)
        if (const Comp3dPoint* point = ground_.placed(position.point)) places.emplace_back(point->p.data());
    if (places.size() < 3) return std::nullopt;
    const Eigen::Vector3d& a = places.front();
    const auto far =
        std::ranges::max_element(places, {}, [&](const Eigen::Vector3d& p) { return (p - a).squaredNorm(); });
    const Eigen::Vector3d b = *far - a;
    const auto off = std::ranges::max_element(
        places, {}, [&](const Eigen::Vector3d& p) { return b.cross(p - a).squaredNorm(); });
    const Eigen::Vector3d c = *off - a, normal = b.cross(c);
    if (!(normal.norm() > 1e-6 * b.squaredNorm())) return std::nullopt;
    const Eigen::Vector3d to_middle =
        (c.squaredNorm() * normal.cross(b) + b.squaredNorm() * c.cross(normal)) /
        (2.0 * normal.squaredNorm());
    return Circle{a + to_middle, to_middle.norm()};
}

bool Comp3dAxes::take(const Comp3dAxis& axis) {
    const auto circle = axis.positions.empty() ? std::nullopt : circle_of(axis);
    if (!circle || !std::isfinite(circle->radius)) return false;
    const std::string name = axis.origin + " " + axis.positions.front().target;
    entry_.points.push_back(
        {.name = name, .p = {circle->middle.x(), circle->middle.y(), circle->middle.z()}});
    entry_.frames.push_back({.name = name, .shape = "plane"});
    readings_.add({.kind = "frame-z", .from = name, .frame = name, .u = u_of_middle}, axis.at);
    for (const Comp3dAxis::Position& p : axis.positions) {
        NetworkReading across{.kind = "slope-distance", .from = name, .to = p.point, .instrument = name};
        across.value = circle->radius;
        across.u = std::abs(p.sigma_radius);
        across.is_used = p.sigma_radius >= 0.0;
        const Comp3dPoint* point = ground_.placed(p.point);
        const double larger =
            point
                ? ground_.site().larger("slope-distance",
                                        {.from = circle->middle, .to = Eigen::Vector3d(point->p.data())}, 0.0)
                : 0.0;
        readings_.add(std::move(across), p.at, -larger);
        NetworkReading off{.kind = "frame-z", .from = p.point, .frame = name};
        off.u = std::abs(p.sigma_off);
        off.is_used = p.sigma_off >= 0.0;
        readings_.add(std::move(off), p.at);
    }
    entry_.figures.push_back({name, "zero", "unknown"});
    return true;
}

}  // namespace covaria
