// Gradients of distance and angle, and whether the first order is enough.
#include "core/result/point_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace covaria {
namespace {

constexpr double largest_shift = 0.1;   // largest shift by terms of the second order, in u
constexpr double largest_spread = 0.1;  // largest spread of a way's length, rad

double root(double variance) {
    return std::sqrt(std::max(0.0, variance));
}

}  // namespace

PointMeasure measured_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               const Eigen::Matrix<double, 6, 6>& covariance) {
    PointMeasure measure;
    measure.value = (b - a).norm();
    if (!(measure.value > 0)) return measure;
    const Eigen::Vector3d along = (b - a) / measure.value;
    Eigen::Matrix<double, 3, 6> difference;
    difference << -Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d V = difference * covariance * difference.transpose();
    const double variance = along.dot(V * along);
    measure.standard_uncertainty = root(variance);
    // d = d_0 + e_parallel + e_perpendicular^2 / (2 d_0) + ...
    const double shift = std::max(0.0, V.trace() - variance) / (2 * measure.value);
    measure.linear = shift <= largest_shift * measure.standard_uncertainty;
    return measure;
}

PointMeasure measured_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& apex, const Eigen::Vector3d& b,
                            const Eigen::Matrix<double, 9, 9>& covariance) {
    PointMeasure measure;
    const double to_a = (a - apex).norm(), to_b = (b - apex).norm();
    if (!(to_a > 0 && to_b > 0)) return measure;
    const Eigen::Vector3d p = (a - apex) / to_a, q = (b - apex) / to_b;
    const double sine = p.cross(q).norm(), cosine = p.dot(q);
    measure.value = std::atan2(sine, cosine);
    if (!(sine > 0)) return measure;
    const Eigen::Vector3d by_a = (cosine * p - q) / (sine * to_a), by_b = (cosine * q - p) / (sine * to_b);
    Eigen::Matrix<double, 1, 9> gradient;
    gradient << by_a.transpose(), -(by_a + by_b).transpose(), by_b.transpose();
    measure.standard_uncertainty = root((gradient * covariance * gradient.transpose()).value());
    // Out of the plane the directions part by e; the angle grows by e^2 cot(angle) / 2.
    const Eigen::Vector3d normal = p.cross(q) / sine;
    Eigen::Matrix<double, 1, 9> apart;
    apart << normal.transpose() / to_a, (1 / to_b - 1 / to_a) * normal.transpose(),
        -normal.transpose() / to_b;
    const double shift =
        std::abs(cosine / sine) / 2 * std::max(0.0, (apart * covariance * apart.transpose()).value());
    const double spread = std::max(root(covariance.topLeftCorner<6, 6>().trace()) / to_a,
                                   root(covariance.bottomRightCorner<6, 6>().trace()) / to_b);
    measure.linear = shift <= largest_shift * measure.standard_uncertainty && spread <= largest_spread;
    return measure;
}

}  // namespace covaria
