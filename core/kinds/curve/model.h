// Measurement model "calibration curve": straight line or polynomial by least squares.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor calibration_curve_model();

}  // namespace covaria
