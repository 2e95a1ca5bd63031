// Places of a design in space: what was found, what was offered, the way of the search. Plain data; m, in
// W.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/model/layout.h"

namespace covaria {

/// Something that the variables move.
struct DesignTrack {
    std::string name;  ///< "laser-tracker"
    std::optional<Eigen::Vector3d> before{};
    Eigen::Vector3d chosen = Eigen::Vector3d::Zero();
    /// Corners of where it may be, of the k variables that move it: 2^k, corner i at the upper end of
    /// variable j where bit j of i is set. Empty for more than three.
    std::vector<Eigen::Vector3d> region{};
    std::vector<Eigen::Vector3d> path{};  ///< the best so far, to the chosen place
    std::vector<double> objectives{};     ///< one for each place of the path
};

/// A box along the axes that no instrument stands in, or that no line of sight passes.
struct DesignObstacle {
    std::string name;
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
};

struct DesignPlaces {
    Layout layout{};  ///< that of the chosen design; its items come from no field, because rows have moved up
    std::vector<DesignTrack> tracks{};
    std::vector<DesignObstacle> obstacles{};
};

}  // namespace covaria
