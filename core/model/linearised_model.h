// A model in the neighbourhood of its estimates, by its sensitivity coefficients.
#pragma once

#include <memory>

#include "core/model/measurement_model.h"

namespace covaria {

/// y = y_0 + J (x - x_0) at the estimates of `inputs`: what the law of propagation takes the model for, fast
/// in Monte Carlo. Null where the model has no value or no sensitivity coefficients.
std::shared_ptr<const MeasurementModel> linearised(std::shared_ptr<const MeasurementModel> model,
                                                   const InputSet& inputs);
bool is_linearised(const MeasurementModel& model);

}  // namespace covaria
