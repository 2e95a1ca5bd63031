// Measurement model "points from sensors": coordinates of targets and distances between them, measured by a
// network of sensors (Galetto et al.).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor points_from_sensors_model();

}  // namespace covaria
