// The essentials of an evaluation - estimates, uncertainties, covariance of some outputs - without budget
// and regions: for evaluations by the thousand (studies).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/error.h"
#include "core/model/measurement_model.h"
#include "core/propagation/options.h"

namespace covaria {

struct EvaluationSummary {
    Eigen::VectorXd estimate;
    Eigen::VectorXd standard_uncertainty;
    Eigen::VectorXd expanded_uncertainty;  ///< U as on the result line: see core/result/result_line.h
    Eigen::MatrixXd covariance;            ///< covariance of the chosen outputs
    std::uint64_t failed_trials = 0;
};

/// Evaluates some outputs as `evaluate` does, on the calling thread. `outputs`: their indices. With
/// Method::monte_carlo `options.trials` trials; `advance(n)` is called after each block of n trials, and
/// false ends with Error{cancelled}. The adaptive procedure is treated as Monte Carlo with a fixed number of
/// trials.
Result<EvaluationSummary> evaluate_summary(const MeasurementModel& model, const InputSet& inputs,
                                           const std::vector<std::size_t>& outputs,
                                           const EvaluationOptions& options,
                                           const std::function<bool(std::uint64_t)>& advance);

}  // namespace covaria
