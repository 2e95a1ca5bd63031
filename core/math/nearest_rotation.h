// The rotation nearest to a matrix.
#pragma once

#include <Eigen/SVD>

namespace covaria {

/// Least squares of the elements; a rotation also where the matrix mirrors.
inline Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d signs(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant());
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace covaria
