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
    /// between the same points in a network whose x, y, z are E, N, h. A zenith angle of that network has the
    /// curvature of the Earth already; refraction is in neither.
    double larger(const std::string& kind, const Sight& sight) const;
    /// The vector to the target in east, north, up of the instrument.
    Eigen::Vector3d seen(const Sight& sight) const;

private:
    Eigen::Vector3d direction(const Eigen::Vector3d& point) const;
    Eigen::Matrix3d axes(const Eigen::Vector3d& point) const;

    double radius_;
    Eigen::Vector2d centre_;
};

}  // namespace covaria
