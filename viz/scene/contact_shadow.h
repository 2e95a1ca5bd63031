// The shadow that bodies throw where they stand: darkest where they touch the floor, wide and faint below
// what is far above it.
#pragma once

#include <vector>

#include "viz/scene/solids.h"

namespace covaria {

/// A square of the floor about `middle`, cells in rows from low y to high y.
struct ContactShadow {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double half = 1.0;                 ///< half of its side, m
    std::size_t cells = 0;             ///< along a side
    std::vector<float> darkness = {};  ///< 0 ... 1
};

/// The shadow of everything that stands on the floor of a scene; without cells where there is no floor.
ContactShadow contact_shadow(const Scene& scene);

}  // namespace covaria
