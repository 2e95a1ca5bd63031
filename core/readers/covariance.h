// Covariance matrices of others: checked, and taken apart into standard uncertainties and correlations.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/error.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

struct TakenCovariance {
    Eigen::VectorXd u;                            ///< square roots of the diagonal
    std::vector<StatedCorrelation> correlations;  ///< first < second; zeros are left out
};

/// Error: not symmetric, not finite, a variance of a component or of some combination is negative.
Result<TakenCovariance> take_covariance(const Eigen::MatrixXd& covariance);

}  // namespace covaria
