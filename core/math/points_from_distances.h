// Places of points in space from the distances between them alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace covaria {

/// A distance between points a and b, or between places above them: b's lies higher over b by `rise` than a's
/// over a.
struct TiedDistance {
    std::size_t a = 0, b = 0;
    double length = 0.0, u = 0.0;  ///< > 0
    double rise = 0.0;
};

struct PointsAndDistances {
    std::vector<Eigen::Vector3d> places;     ///< only those that are held count for `points_from_distances`
    std::vector<std::array<bool, 3>> holds;  ///< whether each coordinate is held
    std::vector<TiedDistance> distances;
};

struct PointsByDistances {
    std::vector<Eigen::Vector3d> places;
    double sum_of_squares = 0.0;  ///< of the misfits of the distances in their u
};

/// The places with the least sum of squares that several beginnings lead to, spread about what is held.
/// Where nothing tells an image from its mirror image, either may be found. Same distances, same places.
PointsByDistances points_from_distances(const PointsAndDistances& given);

/// The places of a least sum nearby those given.
PointsByDistances nearest_by_distances(const PointsAndDistances& given);

}  // namespace covaria
