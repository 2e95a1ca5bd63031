// Weighted least squares of linearised readings: what networks of sensors, as assets and as models, have in
// common.
#pragma once

#include <Eigen/Core>

namespace covaria {

/// Whether readings with these derivatives (rows x 3, by the coordinates of a point) determine the point in
/// every direction.
bool localises(const Eigen::MatrixXd& to_point);

/// Standard uncertainties of readings as their weights need them: those stated. Only a reading whose own
/// figure is 0 (what it shares with others may not be) counts as the limit of a small one: 1e-5 of its
/// uncertainty in all, at most a hundredth of the smallest figure of the others. The loss against the limit
/// is of the order of the square. `shared`: rows x deviations of standard uncertainty one.
Eigen::VectorXd weighting_uncertainties(const Eigen::MatrixXd& to_points, const Eigen::VectorXd& u,
                                        const Eigen::MatrixXd& shared);

/// Gain G of the best linear unbiased estimate, G = (Jᵀ C⁻¹ J)⁻¹ Jᵀ C⁻¹ with C = diag(u²) + F Fᵀ (Galetto et
/// al., Eq 4), 3 points x rows. J: `to_points`, rows x 3 points; F: `shared`, rows x deviations of standard
/// uncertainty one, without columns for weights of the readings alone; u > 0.
/// C is not formed: the shared deviations are estimated with the points (mixed model, C. R. Henderson 1975),
/// which stays exact where u is small beside what is shared.
Eigen::MatrixXd least_squares_gain(const Eigen::MatrixXd& to_points, const Eigen::VectorXd& u,
                                   const Eigen::MatrixXd& shared);

/// S = (I + AᵀA)⁻¹ Aᵀ, shared deviations x readings: the estimates of shared deviations of standard
/// uncertainty one from readings r in units of their own, A = diag(1/u) F. Then C⁻¹ r = diag(1/u) (I − A S)
/// diag(1/u) r.
Eigen::MatrixXd estimate_of_shared(const Eigen::MatrixXd& A);

}  // namespace covaria
