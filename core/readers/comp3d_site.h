// The sphere and the stereographic plane of a Comp3D network, and what its readings are in a flat one.
#pragma once

#include <Eigen/Core>
#include <string>

namespace covaria {

/// Points are E, N in the plane that touches the sphere at the centre, and h above the sphere, m.
class Comp3dSite {
public:
    Comp3dSite(double radius, const Eigen::Vector2d& centre) : radius_(radius), centre_(centre) {}
    /// The radius by which the ellipsoid GRS80 curves on the whole at a latitude, rad.
    static double radius_at(double latitude);
    double radius() const { return radius_; }

    struct Sight {
        Eigen::Vector3d from, to;
        double height_from = 0.0, height_to = 0.0;
    };
    /// By how much a reading of that kind of the network model, m or rad, is larger on the sphere than
    /// between the same points in a network whose x, y, z are E, N, h. A zenith angle has refraction in both:
    /// that network has it with the curvature of the Earth, Comp3D as an angle by the horizontal distance.
    double larger(const std::string& kind, const Sight& sight, double refraction) const;
    /// The vector to the target in east, north, up of the instrument; in the flat network; there with what
    /// curvature and refraction make of a zenith angle in that network.
    Eigen::Vector3d seen(const Sight& sight) const;
    static Eigen::Vector3d flat(const Sight& sight);
    Eigen::Vector3d curved(const Sight& sight, double refraction) const;
    /// The flat vector to what a level instrument at that height sees as `v`, turned about the vertical
    /// alike.
    Eigen::Vector3d flat_of_level(const Eigen::Vector3d& v, double height) const;

private:
    Eigen::Vector3d direction(const Eigen::Vector3d& point) const;
    Eigen::Matrix3d axes(const Eigen::Vector3d& point) const;

    double radius_;
    Eigen::Vector2d centre_;
};

}  // namespace covaria
