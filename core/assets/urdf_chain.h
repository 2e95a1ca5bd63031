// The joints of a URDF file and the chain that makes an arm.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria::urdf {

enum class JointKind { fixed, rotating, other };

struct Joint {
    std::string name, type, parent, child;
    JointKind kind = JointKind::other;
    Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();  ///< its frame in that of the parent link
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();         ///< in its own frame
    bool limited = false;
    double low = 0.0, high = 0.0;  ///< rad
};

struct Robot {
    std::string name;
    std::vector<Joint> joints = {};  ///< in the order of the file
};

/// Links from root to tip: the joints between them.
struct Chain {
    std::string root, tip;
    std::vector<Joint> joints = {};
};

Result<Robot> read(const std::string& xml);
/// See import_urdf.
Result<Chain> chain_to(const Robot& robot, const std::string& tip);

}  // namespace covaria::urdf
