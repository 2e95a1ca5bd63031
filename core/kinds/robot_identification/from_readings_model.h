// Measurement model "robot from readings": identification of an arm from distances, planes and reflectors.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor robot_from_readings_model();

}  // namespace covaria
