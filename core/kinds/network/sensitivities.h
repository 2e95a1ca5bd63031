// Sensitivity coefficients of a network, target by target: a target depends on the stations and on its own
// readings only, unless targets are estimated together.
#pragma once

#include "core/kinds/network/setup.h"
#include "core/model/measurement_model.h"

namespace covaria::network {

/// The rows of MeasurementModel::sensitivities for a network.
bool network_sensitivities(const NetworkSetup& setup, std::span<const double> x, SensitivityRows& rows);

}  // namespace covaria::network
