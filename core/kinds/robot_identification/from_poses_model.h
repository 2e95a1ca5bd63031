// Measurement model "robot from measured poses": identification of an arm by least squares.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor robot_calibration_model();

}  // namespace covaria
