// The joints of a URDF file and the chain that makes an arm.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/base/text_places.h"
#include "core/kinds/robot/urdf.h"

namespace covaria::urdf {

enum class JointKind { fixed, rotating, sliding, other };

struct Joint {
    std::string name, type, parent, child;
    int line = 0;              ///< line of the file where it begins
    std::string follows = {};  ///< name of the joint that it mimics
    JointKind kind = JointKind::other;
    Eigen::Isometry3d X_PJ = Eigen::Isometry3d::Identity();  ///< its frame in that of the parent link
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();         ///< axis in the joint's own frame
    bool limited = false;
    double low = 0.0, high = 0.0;  ///< rad or m

    bool turns() const { return type == "revolute" || type == "continuous"; }
    bool slides() const { return type == "prismatic"; }
    bool moves() const { return kind == JointKind::rotating || kind == JointKind::sliding; }
    /// Makes it a fixed joint, at a value in rad or m.
    void freeze(double value);
};

struct Robot {
    std::string name;
    int line = 0;                    ///< line of the file where it begins
    std::vector<Joint> joints = {};  ///< in the order of the file
};

/// A remark on a joint of the file that is none of the arm: what became of it.
struct Remark {
    std::string joint;
    Message words;
};

/// Links from root to tip: the joints between them.
struct Chain {
    std::string root, tip;
    std::vector<Joint> joints = {};
    std::vector<Remark> remarks = {};
};

Result<Robot> read(const std::string& xml);
/// Freezes joints by name. Error: no such joint, or one that does not move.
Result<std::vector<Remark>> freeze(Robot& robot, const std::vector<FrozenJoint>& frozen);
/// See import_urdf. Linear in the number of joints.
Result<Chain> chain_to(const Robot& robot, const std::string& tip);

}  // namespace covaria::urdf
