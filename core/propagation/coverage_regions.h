// Joint coverage regions of several outputs (JCGM 102 6.5, 7.7).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/propagation/run_context.h"

#include "core/propagation/first_order.h"
#include "core/propagation/trial_block_runner.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// Regions for each group of two or more measurands; in groups of more than three also for each three
/// consecutive outputs of one dimension (the position of a pose). First-order factors are filled in: k_p
/// from chi-squared (JCGM 102 6.5.2), k_q by Bonferroni (6.5.3); from F and t with the smallest effective
/// degrees of freedom of the outputs where those are finite, as k of one output is.
std::vector<CoverageRegion> declare_regions(const std::vector<OutputQuantity>& outputs,
                                            const LawOfPropagation& law, double probability);

/// Whether the covariance of these outputs has no inverse: smallest eigenvalue of the correlation matrix
/// below 1e-10 of the greatest, an output without uncertainty, or one whose variance is not finite.
bool is_singular(const OutputCovariance& covariance, const std::vector<std::size_t>& outputs);

/// Distances of trials from the mean, in which the regions are the sets "distance <= k" (7.7.2, 7.7.3).
/// Outputs that depend linearly on each other have a rectangle only: their covariance has no factor to
/// measure an ellipsoid by, and whether rounding leaves it one is chance.
class RegionDistances {
public:
    RegionDistances(const std::vector<std::size_t>& outputs, const Eigen::VectorXd& mean,
                    const OutputCovariance& covariance);
    bool has_ellipsoid() const { return inverse_factor_.size() > 0; }
    /// Squared ellipsoidal distance of each of `count` trials (row j at first_row + j * block_trials), where
    /// there is an ellipsoid.
    void ellipsoid_squared(const double* first_row, std::size_t count, double* distances) const;
    void rectangle(const double* first_row, std::size_t count, double* distances) const;

private:
    std::vector<std::size_t> outputs_;
    Eigen::VectorXd mean_;
    Eigen::VectorXd inverse_u_;       ///< 0 for an output without uncertainty
    Eigen::MatrixXd inverse_factor_;  ///< L^-1 with U = L L^T; empty: no ellipsoid
};

/// The q-th smallest distance (JCGM 102 7.7.2 f). Reorders them.
double factor_of(std::vector<double>& distances, double probability);

/// Fills in the Monte Carlo factors from the first min(trials, region_trials) trials of the run,
/// regenerated, about the mean and with the covariance of the whole run. Error: cancelled.
Result<void> fill_monte_carlo_factors(std::vector<CoverageRegion>& regions, const RunContext& context,
                                      const Eigen::VectorXd& mean, const OutputCovariance& covariance,
                                      std::uint64_t trials);

}  // namespace covaria::detail
