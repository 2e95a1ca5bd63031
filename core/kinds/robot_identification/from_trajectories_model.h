// Measurement model "robot by joint trajectories": circle point analysis (Wen et al., 2.1).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor robot_circle_points_model();

}  // namespace covaria
