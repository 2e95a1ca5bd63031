// Distances and angles between points, with their standard uncertainties by the law of propagation.
#pragma once

#include <Eigen/Core>

namespace covaria {

struct PointMeasure {
    double value = 0.0;                 ///< m, or rad
    double standard_uncertainty = 0.0;  ///< u_c, in the same unit; without meaning where not `linear`
    /// Terms of the second order shift the value by less than a tenth of u (JCGM 100 5.1.2, NOTE). They do
    /// not where points are closer than their uncertainties, or an angle is nearly 0 or 180 degrees.
    bool linear = false;
};

/// |p_B - p_A|. The joint covariance (6 x 6, m^2) of A and B (JCGM 102 6.2.1, one output quantity).
PointMeasure measured_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               const Eigen::Matrix<double, 6, 6>& covariance);

/// Angle at the apex between the ways to A and to B, 0 ... pi. The joint covariance (9 x 9, m^2) of A, apex
/// and B, in this order.
PointMeasure measured_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& apex, const Eigen::Vector3d& b,
                            const Eigen::Matrix<double, 9, 9>& covariance);

}  // namespace covaria
