// Measurement model "pose from points": position and orientation of a moving frame in a base frame, both
// defined by measured points (Porath et al.).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor pose_from_points_model();

}  // namespace covaria
