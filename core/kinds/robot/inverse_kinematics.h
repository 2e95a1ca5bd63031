// Inverse kinematics of a serial robot.
#pragma once

#include <optional>
#include <vector>

#include "core/kinds/robot/serial_robot.h"

namespace covaria::robot {

struct Target {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::optional<Eigen::Matrix3d> orientation = {};  ///< empty: any
};

struct InverseSolution {
    std::vector<double> q;  ///< readings; empty: nothing found
    double distance = 0.0;  ///< least distance of an attempt from the position, m
};

/// Readings within the limits at which the tool is at the target (base frame), the solution nearest to
/// `start`: damped least squares (Levenberg-Marquardt) from `start` and a fixed set of further readings.
InverseSolution solve_inverse(const SerialRobotSource& robot, const Target& target,
                              const std::vector<double>& start);

}  // namespace covaria::robot
