// Distribution of RP of ISO 9283, l̄ + 3 s_l of distances to the barycentre, when cycles are few.
//
// The RP of infinitely many cycles is E|e| + 3 sd|e| for the deviations e, normal with some covariance. For n
// cycles it comes out too small, since the barycentre is estimated too, and it scatters. The ratio of both
// depends on n and the shape of the scatter alone: a pivot, found by simulated campaigns.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/quantity/distribution.h"

namespace covaria::sheets {

/// l̄ + 3 s_l of the rows.
double repeatability(const Eigen::MatrixX3d& points);
/// RP of infinitely many cycles with these standard deviations along the principal axes.
double repeatability_of_scatter(const Eigen::Vector3d& deviations);
/// Mean length of a vector of normal coordinates: ∫ (1 - prod (1 + 2 t d_i^2)^-1/2) t^-3/2 dt/(2 sqrt(pi)).
double mean_length(const Eigen::Vector3d& deviations);

struct RepeatabilityLaw {
    double of_infinite = 0.0;       ///< RP of infinitely many cycles
    double bias = 1.0;              ///< mean RP of n cycles over that of infinitely many
    double relative_u = 0.0;        ///< standard deviation of RP of n cycles over its mean
    std::vector<double> quantiles;  ///< quantiles of RP(infinite)/RP(n), at k/(size - 1)
    /// Distribution of RP(infinite)/RP(n), the factor of an observed RP.
    Distribution factor() const;
    double mean_factor() const;
    double u_factor() const;
    /// Probability that the factor is below a value.
    double probability_below(double factor) const;
};
/// The law from `campaigns` simulated campaigns of n >= 3 cycles, always the same. Beyond 300 cycles from
/// those of 300: bias shrinks as 1/n, scatter as 1/sqrt(n).
RepeatabilityLaw repeatability_law(const Eigen::Vector3d& deviations, int cycles, int campaigns = 4000);

/// Factor of a standard deviation of nu degrees of freedom: sqrt(nu/chi^2), by quantiles of chi-squared.
Distribution deviation_factor(double degrees_of_freedom);

/// Standard deviations along the principal axes of the rows' scatter.
Eigen::Vector3d principal_deviations(const Eigen::MatrixX3d& points);
Eigen::Matrix3d covariance_of(const Eigen::MatrixX3d& points);

}  // namespace covaria::sheets
