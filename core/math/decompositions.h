// Eigen's decompositions, asked whether they succeeded: what they leave behind otherwise is no result.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <optional>

#include "core/base/guarded.h"

namespace covaria {

/// Cholesky factors of a symmetric matrix. Throws ImpossibleValue if it is not positive definite.
template <class Derived>
auto cholesky(const Eigen::MatrixBase<Derived>& matrix) {
    Eigen::LLT<typename Derived::PlainObject> factors(matrix);
    // info() says nothing about values that are no numbers.
    if (factors.info() != Eigen::Success || !factors.matrixLLT().allFinite())
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

/// Singular values, falling, and vectors as `options` ask. Throws ImpossibleValue where there are none
/// (values that are not finite).
template <class Derived>
auto singular_values(const Eigen::MatrixBase<Derived>& matrix, unsigned int options = 0) {
    const typename Derived::PlainObject values = matrix;
    Eigen::JacobiSVD<typename Derived::PlainObject> svd(values.rows(), values.cols(), options);
    const bool finite = values.allFinite();
    if (finite) svd.compute(values);
    if (!finite || svd.info() != Eigen::Success)
        throw ImpossibleValue("matrix without singular values: some of its values are not finite");
    return svd;
}

/// The step that damped normal equations ask for; nothing where they have no factors or no finite solution:
/// damp more.
std::optional<Eigen::VectorXd> damped_step(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right);

}  // namespace covaria

// Compiled once, in decompositions.cpp, and not in every file that uses them: they are what takes the
// compiler longest.
extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
extern template class Eigen::HouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
extern template Eigen::LLT<Eigen::MatrixXd>& Eigen::LLT<Eigen::MatrixXd>::compute(
    const Eigen::EigenBase<Eigen::MatrixXd>&);
extern template Eigen::LDLT<Eigen::MatrixXd>& Eigen::LDLT<Eigen::MatrixXd>::compute(
    const Eigen::EigenBase<Eigen::MatrixXd>&);
extern template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>&
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>::compute(const Eigen::EigenBase<Eigen::MatrixXd>&, int);
