// Calibrated lengths that an adjustment does not use: the network is held against them.
#pragma once

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

/// A distance as adjusted against its reference, which no reading knows.
struct HeldLength {
    std::size_t distance = 0;  ///< number in `AdjustedNetwork::distances`
    double adjusted = 0.0, reference = 0.0;
    double u = 0.0;  ///< standard uncertainty of their difference
    double difference() const { return adjusted - reference; }
    /// E_n = |d|/U, k = 2.
    double normalised_error() const;
};

/// All distances with a reference, in the order of the set-up.
std::vector<HeldLength> held_lengths(const AdjustedNetwork& network);
Table held_lengths_table(const AdjustedNetwork& network, const std::vector<HeldLength>& held);
/// Warns of lengths with which the network does not agree.
void check_held_lengths(const AdjustedNetwork& network, Problems& problems);

/// The gradient of a distance by the unknowns.
Eigen::VectorXd gradient_of_distance(const AdjustedNetwork& network, std::size_t distance,
                                     const double* state);

}  // namespace covaria::network
