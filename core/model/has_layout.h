// Models of quantities that are nowhere in space have nothing to draw.
#pragma once

#include "core/model/measurement_model.h"

namespace covaria {

/// Whether the model's layout at the estimates of its inputs contains anything.
bool has_layout(const MeasurementModel& model, const InputSet& inputs);

}  // namespace covaria
