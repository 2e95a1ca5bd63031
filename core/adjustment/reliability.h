// Reliability of adjusted readings (W. Baarda 1968): redundancy, standardised residuals, what a test would
// find.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/adjustment/adjustment.h"

namespace covaria::adjustment {

/// The test that outliers are looked for with: significance .1 %, power 80 %, two-sided.
inline constexpr double significance = 0.001, power = 0.8;
/// delta_0 = 4.1321: an error of so many standard deviations of its own test is found with that power.
double non_centrality();
/// |w| beyond this is an outlier at that significance; of several tests, at that of all of them together.
double outlier_limit(std::size_t tests = 1);

struct ReadingReliability {
    double residual = 0.0;    ///< reading less adjusted reading
    double redundancy = 0.0;  ///< r = (Q_vv C⁻¹)_ii; their sum is the degrees of freedom
    double w = 0.0;           ///< standardised residual, with the u that were stated; 0 where not controlled
    double tau = 0.0;         ///< w over s_0 (A. J. Pope 1976)
    double detectable = 0.0;  ///< smallest error that the test finds; infinite where not controlled
    bool controlled = false;
};

struct Reliability {
    std::vector<ReadingReliability> readings;
    double sum_of_squares = 0.0;  ///< vᵀ C⁻¹ v
    int degrees_of_freedom = 0;
    double s0 = 0.0;  ///< root of their ratio; 0 without redundancy
};

/// Returns the reliability of every reading; `residuals`: reading less what the unknowns make of it, at the
/// solution; `blocks` as in the whitening.
Reliability reliability_of(const Adjustment& adjustment, const SparseRows& whitening,
                           const std::vector<CovarianceBlock>& blocks, const Eigen::VectorXd& residuals);

/// Changes of the unknowns by an error of one in the reading.
Eigen::VectorXd effect_of(const Adjustment& adjustment, const SparseRows& whitening, std::size_t reading);

}  // namespace covaria::adjustment
