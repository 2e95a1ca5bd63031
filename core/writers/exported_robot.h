// The robot that a file for others is about, with its uncertainties in words.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/kinds/robot/arm_frames.h"
#include "core/writers/writer.h"

namespace covaria {

struct ExportedRobot {
    std::string id, name;
    ArmFrames arm;
    std::vector<std::string> parameters;  ///< a line for each joint: values and standard uncertainties
    std::vector<std::string> said;        ///< sentences about what the lines could not say
};

/// The robot that no other was made from, among those that the analyses use or find: the identified before
/// the nominal. Without analyses it is the robot of the project. Error: none, or several; the message names
/// them.
Result<ExportedRobot> exported_robot(const WriterSource& source);

/// The fixed-axis angles of URDF, rad: roll, pitch, yaw. They lead back to R everywhere.
std::array<double, 3> roll_pitch_yaw(const Eigen::Matrix3d& R);

/// The pose in words: "(1, 2, 3) mm, turned by (0, 90, 0) deg".
std::string pose_words(const Eigen::Isometry3d& X);

}  // namespace covaria
