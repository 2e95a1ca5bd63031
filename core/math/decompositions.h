// Eigen's decompositions, asked whether they succeeded: what they leave behind otherwise is no result.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/base/guarded.h"

namespace covaria {

/// Cholesky factors of a symmetric matrix. Throws ImpossibleValue if it is not positive definite.
template <class Derived>
auto cholesky(const Eigen::MatrixBase<Derived>& matrix) {
    Eigen::LLT<typename Derived::PlainObject> factors(matrix);
    if (factors.info() != Eigen::Success)
        throw ImpossibleValue(
            "system of equations without a unique solution: its matrix is not positive definite (singular "
            "geometry, or uncertainties that differ by too many orders of magnitude)");
    return factors;
}

/// Eigenvalues, rising, and eigenvectors of a symmetric matrix. Throws ImpossibleValue where there are none
/// (values that are not finite).
template <class Derived>
auto eigen_decomposition(const Eigen::MatrixBase<Derived>& matrix, int options = Eigen::ComputeEigenvectors) {
    Eigen::SelfAdjointEigenSolver<typename Derived::PlainObject> solver;
    if (matrix.allFinite()) solver.compute(matrix, options);
    if (!matrix.allFinite() || solver.info() != Eigen::Success)
        throw ImpossibleValue("matrix without eigenvalues: some of its values are not finite");
    return solver;
}

}  // namespace covaria
