// Residuals of the readings of a network near its estimates, as trials need them: changes of predictions, for
// which an angle takes no arctangent.
#pragma once

#include <span>

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

/// Predictions at the estimates of an adjusted network, which must outlive this, and their changes near them.
class NearPredictions {
public:
    explicit NearPredictions(const AdjustedNetwork& network);

    /// The readings x less their predictions at the estimates; angles on the circle.
    void at_estimates(std::span<const double> x, std::vector<double>& residuals) const;
    /// The readings x less their predictions at the state; `begun`: those at the estimates. `moved` is the
    /// state less the estimates.
    void at_state(std::span<const double> x, const std::vector<double>& begun,
                  const std::vector<double>& state, const std::vector<double>& moved,
                  std::vector<double>& residuals) const;

private:
    /// A reading by a levelled instrument without figures: what its prediction takes of the estimates.
    struct Sight {
        ReadingKind kind = ReadingKind::slope_distance;
        bool is_plain = false;  ///< false: its prediction is computed as a whole
        std::size_t from = 0, to = 0, orientation = 0;
        Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< vector to the target
        double length = 0.0;                          ///< of v, or of its part in the plane
    };
    double change(const Sight& sight, const std::vector<double>& moved) const;

    const AdjustedNetwork& network_;
    double sense_;  ///< 1 where angles grow from x towards y, else -1
    std::vector<double> predicted_;
    std::vector<Sight> sights_;
};

}  // namespace covaria::network
