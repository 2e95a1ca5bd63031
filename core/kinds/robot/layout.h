// An arm as a picture: links, joint axes, triads.
#pragma once

#include "core/kinds/robot/serial_robot.h"
#include "core/model/layout.h"

namespace covaria {

/// Adds the arm at the readings q (rad or m) to a layout, in the world frame; `group` as in LayoutItems.
void add_arm(const SerialRobotSource& robot, const std::vector<double>& q, const std::string& group,
             Layout& layout);

}  // namespace covaria
