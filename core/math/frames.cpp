// Checks of point sets before a frame is made from them.
#include "core/math/frames.h"

#include "core/math/decompositions.h"

namespace covaria {

double sine_of_corner(const Eigen::Vector3d& q1, const Eigen::Vector3d& q2, const Eigen::Vector3d& q3) {
    const Eigen::Vector3d d = q2 - q1, e = q3 - q1;
    const double product = d.norm() * e.norm();
    return product > 0.0 ? d.cross(e).norm() / product : 0.0;
}

double spread_off_a_line(std::span<const Eigen::Vector3d> points) {
    if (points.size() < 3) return 0.0;
    Eigen::Matrix3Xd centred(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) centred.col(static_cast<Eigen::Index>(i)) = points[i];
    centred.colwise() -= centred.rowwise().mean().eval();
    const Eigen::Vector3d s = singular_values(centred * centred.transpose()).singularValues();
    return s[0] > 0.0 ? std::sqrt(s[1] / s[0]) : 0.0;
}

}  // namespace covaria
