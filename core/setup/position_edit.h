// Writes a position or an orientation into a set-up, at the place that a LayoutSource names: dragging in a
// picture.
#pragma once

#include <Eigen/Core>
#include <string>

#include "core/setup/setup_schema.h"

namespace covaria {

/// `path`: a pose ("/station") or a row of a table with columns x, y, z ("/targets/rows/3"). `p` in m, in the
/// frame of the field; coordinates that changed are rounded to the power of ten below `step` (m) in their own
/// unit, the others stay as typed. A table read from a CSV file becomes a typed one. False where the path
/// names no position.
bool write_position(const SetupSchema& schema, Setup& setup, const std::string& path,
                    const Eigen::Vector3d& p, double step);

/// The orientation of a pose ("/station") as Z-Y-X angles, in the frame of the field; angles that changed are
/// rounded to the power of ten below `step` (rad) in their own unit. False where the path names no pose.
bool write_orientation(const SetupSchema& schema, Setup& setup, const std::string& path,
                       const Eigen::Matrix3d& R, double step);

}  // namespace covaria
