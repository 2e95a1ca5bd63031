// Several readings together as the candidate for an error (W. Baarda 1968, multidimensional).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/adjustment/adjustment.h"

namespace covaria::adjustment {

struct GroupTest {
    double statistic = 0.0;  ///< decrease of vᵀ C⁻¹ v when the readings are left out
    int redundancy = 0;      ///< redundancy of the readings, that the others control
    double p = 1.0;          ///< probability of so large a statistic, by chi-square
};

/// The test of the readings together; `residuals` are those of all readings, at the solution.
GroupTest test_of_group(const Adjustment& adjustment, const SparseRows& whitening,
                        const Eigen::VectorXd& residuals, const std::vector<std::size_t>& readings);

}  // namespace covaria::adjustment
