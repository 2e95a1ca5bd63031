// Fields of a serial robot.
#pragma once

#include "core/kinds/robot/serial_robot.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// More joints than any arm in the library has.
inline constexpr std::size_t most_joints = 7;

SetupSchema robot_schema();

/// "u_theta" of the table of uncertainties.
std::string uncertainty_key(JointParameter parameter);

}  // namespace covaria
