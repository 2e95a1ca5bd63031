// The measurement model "accuracy and repeatability of poses" (ISO 9283).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor robot_poses_model();

}  // namespace covaria
