#include "core/math/plane_of_points.h"

#include "core/math/decompositions.h"

namespace covaria {

PlaneOfPoints plane_of(const std::vector<Eigen::Vector3d>& places) {
    constexpr double about = 0.02;  // of the longest extent
    PlaneOfPoints plane;
    for (const Eigen::Vector3d& p : places) plane.middle += p / static_cast<double>(places.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : places) moments += (p - plane.middle) * (p - plane.middle).transpose();
    const auto axes = eigen_decomposition(moments);
    plane.normal = axes.eigenvectors().col(0);
    plane.is_flat = axes.eigenvalues()[0] < about * about * axes.eigenvalues()[2];
    plane.is_a_line = axes.eigenvalues()[1] < about * about * axes.eigenvalues()[2];
    return plane;
}

}  // namespace covaria
