// The Gaussian copula of correlated components: which coefficient gives the stated correlation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/quantity/input_quantity.h"

namespace covaria::detail {

/// Correlated components are drawn as F^-1(Phi(z)) of correlated standard normal z. Where they are not normal
/// their (Pearson) correlation is not that of z: with g the standardised function of z and a_k its
/// coefficients by normalised Hermite polynomials, r(rho) = sum a_k b_k rho^k (Mehler), rising from r(-1) to
/// r(1). The result has, for each of `correlations` (as from `resolved_correlations`), the rho with r(rho) =
/// the coefficient stated. Members of one estimate of variance keep theirs; so do components without a finite
/// standard deviation, whose correlation does not exist, and +-1 of quantities that combine arithmetically.
/// Error: a correlation that two components with these distributions cannot have.
Result<std::vector<ComponentCorrelation>> copula_coefficients(
    const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations);

/// The positive semi-definite matrix with diagonal 1 that the matrix becomes without its negative
/// eigenvalues; itself if it has none.
Eigen::MatrixXd nearest_correlation(const Eigen::MatrixXd& matrix);

}  // namespace covaria::detail
