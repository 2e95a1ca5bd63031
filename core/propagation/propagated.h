// The law of propagation of a model at its inputs: what every evaluation of them begins with.
#pragma once

#include <memory>
#include <mutex>

#include "core/propagation/first_order.h"

namespace covaria {

struct Propagation {
    detail::Correlations correlations;
    detail::LawOfPropagation law;
};

/// Errors: as `evaluate`, before the first trial.
Result<Propagation> propagate(const MeasurementModel& model, const InputSet& inputs);

/// A model with its inputs, whose law of propagation is computed when it is first asked for, and once: the
/// forecast, live results, previews and runs share it. Safe to use from many threads.
class PropagatedModel {
public:
    /// `inputs`: the model's, possibly edited.
    PropagatedModel(std::shared_ptr<const MeasurementModel> model, std::shared_ptr<const InputSet> inputs);
    /// The same numbers under other names: what `known` has is shared.
    PropagatedModel(std::shared_ptr<const MeasurementModel> model, std::shared_ptr<const InputSet> inputs,
                    const PropagatedModel& known);

    const std::shared_ptr<const MeasurementModel>& model() const { return model_; }
    const InputSet& inputs() const { return *inputs_; }
    const std::shared_ptr<const InputSet>& shared_inputs() const { return inputs_; }
    /// Errors: as `propagate`.
    const Result<Propagation>& propagation() const;
    /// Whether somebody has asked for the law.
    bool is_computed() const;

private:
    struct Once {
        std::mutex mutex;
        std::unique_ptr<const Result<Propagation>> propagation;
    };
    std::shared_ptr<const MeasurementModel> model_;
    std::shared_ptr<const InputSet> inputs_;
    std::shared_ptr<Once> once_;
};

}  // namespace covaria
