#include "core/propagation/propagated.h"

#include <utility>

#include "core/propagation/engine_parts.h"

namespace covaria {

Result<Propagation> propagate(const MeasurementModel& model, const InputSet& inputs) {
    auto correlations = detail::checked_correlations(model, inputs);
    if (!correlations) return fail(correlations.error());
    auto law = detail::law_of_propagation(model, inputs, *correlations);
    if (!law) return fail(law.error());
    return Propagation{std::move(*correlations), std::move(*law)};
}

PropagatedModel::PropagatedModel(std::shared_ptr<const MeasurementModel> model,
                                 std::shared_ptr<const InputSet> inputs)
    : model_(std::move(model)), inputs_(std::move(inputs)), once_(std::make_shared<Once>()) {}

PropagatedModel::PropagatedModel(std::shared_ptr<const MeasurementModel> model,
                                 std::shared_ptr<const InputSet> inputs, const PropagatedModel& known)
    : model_(std::move(model)), inputs_(std::move(inputs)), once_(known.once_) {}

const Result<Propagation>& PropagatedModel::propagation() const {
    const std::lock_guard lock(once_->mutex);
    if (!once_->propagation)
        once_->propagation = std::make_unique<const Result<Propagation>>(propagate(*model_, *inputs_));
    return *once_->propagation;
}

bool PropagatedModel::is_computed() const {
    const std::lock_guard lock(once_->mutex);
    return once_->propagation != nullptr;
}

}  // namespace covaria
