// Control variates of an evaluation by the thousand: few trials, all figures from one sample.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/propagation/first_order.h"
#include "core/propagation/linear_distribution.h"
#include "core/propagation/linear_rows.h"
#include "core/result/uncertainty_result.h"

namespace covaria::detail {

/// Figures of some outputs, and after them of the linear parts of those that have one.
struct TrialFigures {
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
    std::vector<CoverageInterval> intervals;
};

/// The linear parts of the outputs looked at. A run of the engine cuts its trials into batches, to know
/// standard errors; here nobody asks for those, and the trials are too few to be cut.
class SummaryControls {
public:
    SummaryControls(const InputSet& inputs, const Correlations& correlations, const LawOfPropagation& law,
                    const std::vector<std::size_t>& outputs);

    const LinearRows& rows() const { return rows_; }
    /// Reads each figure where the linear part has its exact expectation, covariance or quantile, along the
    /// regression of the output on its linear part. An output of which that explains less than a third of the
    /// variance stays as it is, and so does an interval end that is not known better of the linear part than
    /// from so many trials.
    void improve(TrialFigures& figures, double probability, std::uint64_t trials) const;

private:
    std::vector<std::size_t> place_of_;  ///< place of each row among the outputs looked at
    std::vector<LinearDistribution> distributions_;
    LinearRows rows_{{}};
    Eigen::MatrixXd covariance_;  ///< exact, of the linear parts of the rows
};

}  // namespace covaria::detail
