// The uncertainty engine: law of propagation and propagation of distributions. Knows the model interface,
// never a model.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/run_control.h"
#include "core/model/measurement_model.h"
#include "core/propagation/options.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

class PropagatedModel;  // core/propagation/propagated.h

/// Evaluates `model` with `inputs` (the model's own, possibly edited: same quantities in the same order).
/// Synchronous; the same arguments give the same bits for any number of threads.
/// Errors: bad options or inputs (path names the field), Error{cancelled} within 100 ms of a stop request,
/// Error{numeric} when the model has no value at the estimates or every trial failed.
Result<UncertaintyResult> evaluate(const MeasurementModel& model, const InputSet& inputs,
                                   const EvaluationOptions& options, const RunControl& control = {});
/// The same bits; the law of propagation is shared with whoever else asks the model for it.
Result<UncertaintyResult> evaluate(const PropagatedModel& model, const EvaluationOptions& options,
                                   const RunControl& control = {});

/// Largest number of blocks of trials of such a run, which several processes may share (`RunControl::units`).
/// Small parts beside them (pilot, regions, contributors) are done by each process for itself.
std::uint64_t units_of_run(const EvaluationOptions& options);

/// Law of propagation only (JCGM 100/102): for live editing.
Result<UncertaintyResult> evaluate_first_order(const MeasurementModel& model, const InputSet& inputs,
                                               const EvaluationOptions& options);
Result<UncertaintyResult> evaluate_first_order(const PropagatedModel& model,
                                               const EvaluationOptions& options);

/// Trials first, first+1 ... of a run with this seed, regenerated: column t holds the outputs (inputs) of
/// trial first+t, exactly as the run had them. Trials without a value are NaN columns of `outputs`.
struct ReplayedTrials {
    Eigen::MatrixXd inputs;
    Eigen::MatrixXd outputs;
};
Result<ReplayedTrials> replay_trials(const MeasurementModel& model, const InputSet& inputs,
                                     std::uint64_t seed, std::uint64_t first, std::uint64_t count);
Result<ReplayedTrials> replay_trials(const PropagatedModel& model, std::uint64_t seed, std::uint64_t first,
                                     std::uint64_t count);

}  // namespace covaria
