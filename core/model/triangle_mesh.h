// Triangles of a surface, as a file gives them.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace covaria {

/// Immutable once made and shared; in the unit of its file.
struct TriangleMesh {
    std::vector<float> corners = {};  ///< x y z of three corners for each triangle
    Eigen::AlignedBox3f box = {};     ///< around them

    std::size_t triangles() const { return corners.size() / 9; }
};

}  // namespace covaria
