// The parts of a network that are placed already while the search of an adjustment looks for its beginning.
#pragma once

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

/// Places and orientations in one frame of the plane.
struct PlaneFrame {
    std::vector<std::optional<Eigen::Vector2d>> places;
    std::vector<std::optional<double>> orientations;  ///< orientations of rounds
};

/// Places in the plane and heights, as far as they are known, in the state of the network too.
class Placing {
public:
    /// Begins with coordinates that are typed, and those that were read.
    Placing(AdjustedNetwork& network, PlaneFrame empty);

    PlaneFrame whole;

    bool wants(std::size_t p) const { return network_.points[p].has(0) && !whole.places[p]; }
    bool is_empty() const;
    /// Whether the point has a place, its height too if it has one.
    bool is_in_space(std::size_t p) const { return heights_[p] && !wants(p); }
    void put(std::size_t p, const Eigen::Vector3d& at);
    void put_plane();
    /// Places the heights that follow from those that are placed.
    void spread_heights();
    /// Places the first height, where none is placed; false where one is.
    bool begin_heights();
    /// Places all heights; those that hang on nothing begin at the mean of the others.
    void place_heights();
    /// Places the points that are read in a frame which is laid onto others. Where it `begins`, the frame
    /// with most points lies where the network does.
    bool place_by_own_frames(bool begins);
    void lay_frames();

private:
    void take_coordinate(const AdjustedReading& r);
    std::optional<double> rise(const AdjustedReading& r) const;
    double mean_height() const;
    std::vector<char> placed() const;
    bool place_by(std::size_t f);
    std::size_t largest_frame() const;
    double& height(std::size_t p) { return network_.state[static_cast<Eigen::Index>(network_.at(p, 2))]; }

    AdjustedNetwork& network_;
    std::vector<char> heights_;  ///< whether the height of each point is placed or not part of the network
};

}  // namespace covaria::network
