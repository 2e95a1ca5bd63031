// The input quantities of "accuracy and repeatability of poses", and where they are.
#pragma once

#include <array>

#include "core/kinds/sheets/robot_poses_figures.h"
#include "core/quantity/input_quantity.h"

namespace covaria::sheets {

inline constexpr std::array<const char*, 3> pose_axes{"x", "y", "z"}, pose_angles{"a", "b", "c"};

/// The inputs of each series: barycentre, RP, and with angles their means and 3 s. Then the deviation of the
/// instrument at each pose, mean and 3 s of each distance, RP of the instrument alone.
struct PerformanceInputs {
    InputSet set;
    std::size_t stride = 4;  ///< quantities of a series
    std::size_t first_place = 0, first_distance = 0, instrument = 0;
};

PerformanceInputs performance_inputs(const RobotPosesSetup& setup, const RobotPosesFigures& figures);
Name group_of(const PoseSeries& series);

}  // namespace covaria::sheets
