// The plane that places lie in, or next to.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace covaria {

struct PlaneOfPoints {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::UnitZ();
    bool is_flat = true;     ///< whether the places are about in the plane
    bool is_a_line = false;  ///< whether they are about on a line, which lies in many planes

    Eigen::Vector3d image(const Eigen::Vector3d& of) const {
        return of - 2.0 * normal.dot(of - middle) * normal;
    }
};
/// The plane nearest to the places, of which there are three at least.
PlaneOfPoints plane_of(const std::vector<Eigen::Vector3d>& places);

}  // namespace covaria
