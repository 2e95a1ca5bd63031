#include "core/math/circle_fit.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/math/decompositions.h"

namespace covaria {

namespace {

/// Centre and radius in the plane by the algebraic (Kasa) fit.
Eigen::Vector3d algebraic_circle(const Eigen::Matrix2Xd& q) {
    Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < q.cols(); ++k) {
        const Eigen::Vector3d row(q(0, k), q(1, k), 1.0);
        N += row * row.transpose();
        g += row * q.col(k).squaredNorm();
    }
    const Eigen::Vector3d s = N.fullPivLu().solve(g);
    const Eigen::Vector2d centre = s.head<2>() / 2.0;
    return {centre.x(), centre.y(), std::sqrt(std::max(0.0, s[2] + centre.squaredNorm()))};
}

}  // namespace

CircleShape circle_shape(std::span<const Eigen::Vector3d> points) {
    CircleShape shape;
    const auto n = static_cast<double>(points.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) mean += p / n;
    Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : points) S += (p - mean) * (p - mean).transpose() / n;
    const auto solver = eigen_decomposition(S);
    shape.extents = solver.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
    Eigen::Matrix3d& axes = shape.start.axes;
    axes.col(0) = solver.eigenvectors().col(2);
    axes.col(2) = solver.eigenvectors().col(0);
    axes.col(1) = axes.col(2).cross(axes.col(0));
    Eigen::Matrix2Xd q(2, static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k)
        q.col(static_cast<Eigen::Index>(k)) = (axes.leftCols<2>().transpose() * (points[k] - mean));
    const Eigen::Vector3d circle = algebraic_circle(q);
    shape.start.centre = mean + axes.leftCols<2>() * circle.head<2>();
    shape.start.radius = circle[2];
    double angle = 0.0;
    const auto bearing = [&](Eigen::Index k) { return std::atan2(q(1, k) - circle[1], q(0, k) - circle[0]); };
    for (Eigen::Index k = 0; k < q.cols(); ++k) {
        if (k > 0) angle += std::remainder(bearing(k) - bearing(k - 1), 2.0 * std::numbers::pi);
        shape.angles.push_back(angle);
    }
    if (angle < 0.0) {
        axes.col(1) *= -1.0;
        axes.col(2) *= -1.0;
        for (double& a : shape.angles) a = -a;
    }
    shape.arc = std::abs(angle);
    return shape;
}

}  // namespace covaria
