// Residuals of the readings of a network near its estimates, as trials need them: changes of predictions, for
// which an angle takes no arctangent.
#pragma once

#include <numbers>

#include "core/kinds/network/adjusted_setup.h"
#include "core/kinds/network/readings.h"

namespace covaria::network {

/// Predictions at the estimates of an adjusted network, and how they change near these.
class NearPredictions {
public:
    explicit NearPredictions(const AdjustedNetwork& network);

    std::size_t readings() const { return sights_.size(); }
    /// Whether its change is known here; otherwise the reading is predicted as a whole (`residual_of`).
    bool is_plain(std::size_t reading) const { return sights_[reading].is_plain; }
    bool are_all_plain() const { return are_all_plain_; }

    /// The reading x less its prediction at the estimates; an angle is on the circle.
    template <class Real>
    Real at_estimates(std::size_t reading, const Real& x) const {
        return on_circle(sights_[reading], Real(x - Real(sights_[reading].predicted)));
    }
    /// The same with its prediction at the state, of a plain reading; `begun`: with that at the estimates.
    /// `moved(place)` is the state less the estimates.
    template <class Real, class Moved>
    Real at_state(std::size_t reading, const Real& begun, const Moved& moved) const {
        return on_circle(sights_[reading], Real(begun - change<Real>(sights_[reading], moved)));
    }

private:
    /// A reading by a levelled instrument without figures, or a difference: what its prediction takes of the
    /// estimates.
    struct Sight {
        ReadingKind kind = ReadingKind::slope_distance;
        bool is_plain = false, is_angle = false;
        unsigned from = 0, to = 0, orientation = 0;   ///< places in the state
        Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< vector to the target
        double length = 0.0;                          ///< of v, or of its part in the plane
        double predicted = 0.0;
    };

    template <class Real>
    static Real on_circle(const Sight& sight, const Real& r) {
        using namespace real_functions;
        using std::nearbyint;
        if (!sight.is_angle || !any(abs(r) >= Real(std::numbers::pi))) return r;
        constexpr double turn = 2.0 * std::numbers::pi;
        return Real(r - Real(turn) * nearbyint(Real(r / Real(turn))));
    }

    /// The angle whose tangent is across / along.
    template <class Real>
    static Real angle_of(const Real& across, const Real& along) {
        using namespace real_functions;
        const auto small = abs(across) < Real(Real(small_angle) * along);
        const Real near = small_arctangent(Real(across / along));
        return all(small) ? near : Real(select(small, near, atan2(across, along)));
    }

    template <class Real, class Moved>
    Real change(const Sight& s, const Moved& moved) const {
        using namespace real_functions;
        const Real x = Real(s.v.x()) + (moved(s.to) - moved(s.from));
        const Real y = Real(s.v.y()) + (moved(s.to + 1) - moved(s.from + 1));
        const auto z = [&] { return Real(Real(s.v.z()) + (moved(s.to + 2) - moved(s.from + 2))); };
        const Real level2 = x * x + y * y;
        switch (s.kind) {
            case ReadingKind::slope_distance: {
                const Real height = z();
                return sqrt(Real(level2 + height * height)) - Real(s.length);
            }
            case ReadingKind::horizontal_distance:
                return sqrt(level2) - Real(s.length);
            case ReadingKind::zenith_angle: {
                const Real level = sqrt(level2), height = z(), level_before(s.length), height_before(s.v.z());
                return angle_of(Real(level * height_before - level_before * height),
                                Real(level * level_before + height * height_before));
            }
            default: {
                const Real x_before(s.v.x()), y_before(s.v.y());
                const Real turned =
                    angle_of(Real(x_before * y - y_before * x), Real(x_before * x + y_before * y));
                const Real read = Real(sense_) * turned;
                return s.kind == ReadingKind::direction ? Real(read - moved(s.orientation)) : read;
            }
        }
    }

    double sense_;  ///< 1 where angles grow from x towards y, else -1
    bool are_all_plain_ = true;
    std::vector<Sight> sights_;
};

}  // namespace covaria::network
