// Measurement model "robot pose": the end effector of a serial robot (Wen et al., Eqs 5-7).
#pragma once

#include "core/model/model_descriptor.h"

namespace covaria {

ModelDescriptor robot_pose_model();

}  // namespace covaria
