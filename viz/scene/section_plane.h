// The plane of a section: a value of the view, as what is hidden and the camera are.
#pragma once

#include <Eigen/Core>

namespace covaria {

/// A plane across an axis of W; what lies on one side of it is cut away.
struct SectionPlane {
    int axis = 0;            ///< the one that it is across: 0 x, 1 y, 2 z
    double at = 0.0;         ///< its coordinate along that axis, m
    bool hides_high = true;  ///< what lies beyond it along the axis is cut away; else what lies before it

    /// Distance into the part that is cut away, m; negative in the other one.
    double depth_of(const Eigen::Vector3d& p_W) const { return hides_high ? p_W[axis] - at : at - p_W[axis]; }
    bool hides(const Eigen::Vector3d& p_W) const { return depth_of(p_W) > 0.0; }
    bool operator==(const SectionPlane&) const = default;
};

}  // namespace covaria
