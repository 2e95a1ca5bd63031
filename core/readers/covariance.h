// Covariance matrices of others: checked, and taken apart into standard uncertainties and correlations.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/error.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

struct TakenCovariance {
    Eigen::VectorXd u;                            ///< square roots of the diagonal
    std::vector<StatedCorrelation> correlations;  ///< pairs with first < second; zeros are left out
};

/// The standard uncertainties and correlations of a covariance matrix. Error: it is not symmetric or not
/// finite, or a variance of a component or of some combination is negative.
Result<TakenCovariance> take_covariance(const Eigen::MatrixXd& covariance);

}  // namespace covaria
