// An arm for files of others: frames of its joints as URDF states them, and what is known of its parameters.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/model/asset.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// A joint that turns about, or slides along, the z-axis of its frame by its reading, in rad or m.
struct ArmFrame {
    /// Joint at a reading of zero, in the frame of the joint before it, the first in that of the base.
    Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();
    bool slides = false;
    double low = -std::numeric_limits<double>::infinity();  ///< limits of the reading
    double high = std::numeric_limits<double>::infinity();
};

struct ArmParameter {
    std::size_t joint = 0;
    std::string symbol;                          ///< "theta_3"
    bool length = false;                         ///< m, else rad
    double value = 0.0, u = 0.0;                 ///< SI; u of what the robot itself states
    std::optional<OutputReference> output = {};  ///< output of the analysis that found it, which knows its u
};

struct ArmFrames {
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();  ///< base in the world
    std::vector<ArmFrame> joints;
    std::size_t first_coupled = 0;  ///< number from 1 of the first joint that another moves along; 0: none
    Eigen::Isometry3d X_JT = Eigen::Isometry3d::Identity();  ///< tool in the frame of the last joint
    std::vector<ArmParameter> parameters;
};

/// Exact: whatever the convention, the zero readings and the directions of the joints, tool and readings are
/// those of the robot. None: the asset is no serial robot.
std::optional<ArmFrames> arm_frames(const Asset* asset);

}  // namespace covaria
