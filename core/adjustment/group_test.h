// Several readings together as the candidate for an error (W. Baarda 1968, multidimensional).
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "core/adjustment/adjustment.h"

namespace covaria::adjustment {

struct GroupTest {
    double statistic = 0.0;  ///< decrease of vᵀ C⁻¹ v when the readings are left out
    int redundancy = 0;      ///< redundancy of the readings, that the others control
    double p = 1.0;          ///< probability of so large a statistic, by chi-square
};

/// The tests of many groups of one adjustment: a reading is in several, and its equations are solved once. It
/// holds two matrices of unknowns by readings.
class GroupTests {
public:
    /// `residuals` are those of all readings, at the solution.
    GroupTests(const Adjustment& adjustment, const SparseRows& whitening, const Eigen::VectorXd& residuals);
    /// The test of the readings together.
    GroupTest of(const std::vector<std::size_t>& readings) const;

private:
    /// Whitened errors of each reading alone, of size one: the columns of E.
    Eigen::SparseMatrix<double> errors_;
    Eigen::VectorXd along_;        ///< Eᵀ C⁻¹ v
    Eigen::MatrixXd by_unknowns_;  ///< Aᵀ E, whitened
    Eigen::MatrixXd changes_;      ///< changes of the unknowns by each error
};

}  // namespace covaria::adjustment
