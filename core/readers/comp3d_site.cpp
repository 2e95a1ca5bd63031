#include "core/readers/comp3d_site.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria {

double Comp3dSite::radius_at(double latitude) {
    constexpr double a = 6378137.0, e2 = 0.00669438;  // GRS80
    return a * std::sqrt(1.0 - e2) / (1.0 - e2 * std::pow(std::sin(latitude), 2));
}

/// The place on the unit sphere, the centre of the plane at (0, 0, 1).
Eigen::Vector3d Comp3dSite::direction(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d a = (point.head<2>() - centre_) / radius_;
    const double t = 0.25 * a.squaredNorm();
    return Eigen::Vector3d(a.x(), a.y(), 1.0 - t) / (1.0 + t);
}

/// East, north and up at a point, by columns: the images of the axes of the plane, which keeps angles.
Eigen::Matrix3d Comp3dSite::axes(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d a = (point.head<2>() - centre_) / radius_;
    const double t = 0.25 * a.squaredNorm();
    const Eigen::Vector3d up = direction(point);
    const Eigen::Vector3d east = (Eigen::Vector3d(1.0, 0.0, -0.5 * a.x()) * (1.0 + t) -
                                  0.5 * a.x() * Eigen::Vector3d(a.x(), a.y(), 1.0 - t))
                                     .normalized();
    Eigen::Matrix3d axes;
    axes << east, up.cross(east), up;
    return axes;
}

Eigen::Vector3d Comp3dSite::seen(const Sight& sight) const {
    const Eigen::Vector3d a = (radius_ + sight.from.z() + sight.height_from) * direction(sight.from),
                          b = (radius_ + sight.to.z() + sight.height_to) * direction(sight.to);
    return axes(sight.from).transpose() * (b - a);
}

Eigen::Vector3d Comp3dSite::flat(const Sight& sight) {
    Eigen::Vector3d v = sight.to - sight.from;
    v.z() += sight.height_to - sight.height_from;
    return v;
}

Eigen::Vector3d Comp3dSite::curved(const Sight& sight, double refraction) const {
    Eigen::Vector3d v = flat(sight);
    v.z() -= 0.5 * (1.0 - refraction) * v.head<2>().squaredNorm() / radius_;
    return v;
}

Eigen::Vector3d Comp3dSite::flat_of_level(const Eigen::Vector3d& v, double height) const {
    const double across = v.head<2>().norm(), up = radius_ + height + v.z(),
                 arc = radius_ * std::atan2(across, up);
    Eigen::Vector3d flat = v;
    if (across > 0.0) flat.head<2>() *= arc / across;
    flat.z() = std::hypot(across, up) - radius_ - height;
    return flat;
}

double Comp3dSite::larger(const std::string& kind, const Sight& sight, double refraction) const {
    const Eigen::Vector3d v = seen(sight), level = flat(sight), bent = curved(sight, refraction);
    if (kind == "slope-distance") return v.norm() - level.norm();
    if (kind == "horizontal-distance") {
        const double chord = (direction(sight.to) - direction(sight.from)).norm();
        return 2.0 * radius_ * std::asin(std::min(1.0, 0.5 * chord)) - level.head<2>().norm();
    }
    if (kind == "zenith-angle")
        return std::atan2(v.head<2>().norm(), v.z()) - 0.5 * refraction * v.head<2>().norm() / radius_ -
               std::atan2(bent.head<2>().norm(), bent.z());
    if (kind == "direction" || kind == "azimuth")
        return std::remainder(std::atan2(v.x(), v.y()) - std::atan2(level.x(), level.y()),
                              2.0 * std::numbers::pi);
    return 0.0;
}

}  // namespace covaria
