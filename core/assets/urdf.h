// Import of arms from URDF, the robot description format of ROS.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/model/setup.h"

namespace covaria {

/// An asset made from a foreign file: what a project's entry needs beside an id.
struct ImportedAsset {
    std::string kind, name, notes;
    Setup setup;
};

/// The chain of rotating joints from the root link to `tip`, as a serial robot in the convention of Eq 5
/// (beta for parallel axes). Frame 0 has the z-axis of the first joint; base and tool lead from the root link
/// and to the tip. An empty tip: the link with the most rotating joints before it, reached without a sliding
/// one; of several at the end of the same chain the one called tool0, tcp or flange, else the farthest.
/// Error: no URDF (xacro must be expanded first), no rotating joint, more joints than an arm has here,
/// several arms of equal length without a tip named, a sliding, floating or mimicking joint on the way to the
/// tip.
Result<ImportedAsset> import_urdf(const std::string& xml, const std::string& tip = {});

}  // namespace covaria
