// Measurement model "force-moment loads": forces and moments from the readings of all channels by the
// calibration matrix.
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor force_loads_model();

}  // namespace covaria
