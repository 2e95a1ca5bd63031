// Several readings together as the candidate for an error (W. Baarda 1968, multidimensional).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/adjustment/adjustment.h"

namespace covaria::adjustment {

struct GroupTest {
    double statistic = 0.0;  ///< by so much vᵀ C⁻¹ v falls when the readings are left out
    int redundancy = 0;      ///< of them, that the others control
    double p = 1.0;          ///< of so large a statistic: chi-square
};

/// `residuals`: of all readings, at the solution.
GroupTest test_of_group(const Adjustment& adjustment, const SparseRows& whitening,
                        const Eigen::VectorXd& residuals, const std::vector<std::size_t>& readings);

}  // namespace covaria::adjustment
