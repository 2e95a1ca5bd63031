// Import of arms from URDF, the robot description format of ROS.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/setup/setup.h"

namespace covaria {

/// An asset made from a foreign file: what a project's entry needs beside an id, and what was taken.
struct ImportedAsset {
    std::string kind, name, notes;
    Setup setup;
    std::vector<Message> report;  ///< lines: joints, tool, what is frozen, what was left out and why
};

/// A joint that the imported arm does not have: it stands at a value, in degrees or millimetres.
struct FrozenJoint {
    std::string name;
    double value = 0.0;
};

struct UrdfChoice {
    std::string tip = {};  ///< link at the end of the arm; empty: found
    std::vector<FrozenJoint> frozen = {};
};

/// The chain of moving joints from the root link to the tip, as a serial robot in the convention of Eq 5
/// (beta for parallel axes). Frame 0 has the z-axis of the first joint; base and tool lead from the root link
/// and to the tip. An empty tip: the link with the most moving joints before it; of several at the end of the
/// same chain the one called tool0, tcp or flange, else the farthest. Joints of grippers are never taken:
/// those called so, those that others follow at the end of the arm, those that fork there, and those that
/// slide by less than 100 mm there; on the way to a tip that is named, those called so are frozen.
/// Error, with the line of the file unless it is about `choice`: no URDF (xacro must be expanded first), no
/// moving joint, more joints than an arm has here, several arms of equal length without a tip named, a joint
/// that floats or follows another one on the way to the tip.
Result<ImportedAsset> import_urdf(const std::string& xml, const UrdfChoice& choice = {});

}  // namespace covaria
