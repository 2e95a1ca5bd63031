// The engine with its internal sizes open to tests, and the checks that all its entrances share.
#pragma once

#include "core/propagation/engine.h"
#include "core/propagation/first_order.h"
#include "core/propagation/internal_sizes.h"

namespace covaria::detail {

Result<UncertaintyResult> evaluate_with(const MeasurementModel& model, const InputSet& inputs,
                                        const EvaluationOptions& options, const RunControl& control,
                                        const EngineSettings& settings);

/// Indices, factors, degrees of freedom; the number of quantities against the model's. The correlations.
Result<Correlations> checked_correlations(const MeasurementModel& model, const InputSet& inputs);

/// The result of one output by the law of propagation; the result line is still without k and U.
OutputResult output_result(const OutputQuantity& quantity, const LawOfPropagation& law, Eigen::Index j,
                           const EvaluationOptions& options);

/// The first-order part of a result: outputs, covariance, budget, regions, warnings.
Result<UncertaintyResult> first_order_result(const MeasurementModel& model, const SharedInputs& inputs,
                                             const EvaluationOptions& options, const LawOfPropagation& law);

}  // namespace covaria::detail
