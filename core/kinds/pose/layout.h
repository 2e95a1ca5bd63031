// Layout of the frames, points and plates of "pose from points".
#pragma once

#include <span>

#include "core/kinds/pose/setup.h"
#include "core/model/layout.h"

namespace covaria::pose {

/// World = frame 0. `x` in the order of pose_inputs().
Layout pose_layout(const PoseSetup& setup, std::span<const double> x);

}  // namespace covaria::pose
