#include "core/kinds/network/near_predictions.h"

#include <cmath>
#include <numbers>

#include "core/kinds/network/readings.h"

namespace covaria::network {

namespace {

/// The angle whose tangent is across / along.
double angle_of(double across, double along) {
    if (std::abs(across) < small_angle * along) return small_arctangent(across / along);
    return std::atan2(across, along);
}

double on_circle(ReadingKind kind, double r) {
    if (std::abs(r) < std::numbers::pi || !is_of_angle(kind)) return r;
    return std::remainder(r, 2.0 * std::numbers::pi);
}

bool is_sight(ReadingKind kind) {
    return kind == ReadingKind::slope_distance || kind == ReadingKind::horizontal_distance ||
           kind == ReadingKind::direction || kind == ReadingKind::azimuth ||
           kind == ReadingKind::zenith_angle;
}

}  // namespace

NearPredictions::NearPredictions(const AdjustedNetwork& network)
    : network_(network), sense_(network.clockwise ? -1.0 : 1.0) {
    predicted_.reserve(network.readings.size());
    sights_.reserve(network.readings.size());
    for (const AdjustedReading& r : network.readings) {
        predicted_.push_back(predicted(network, r, network.state.data()));
        Sight sight{.kind = r.kind, .from = 3 * r.from, .to = 3 * r.to};
        sight.is_plain = is_sight(r.kind) && r.figures.empty() && r.tilt == AdjustedReading::no_tilt &&
                         (network.curvature == 0.0 || r.kind != ReadingKind::zenith_angle);
        if (r.kind == ReadingKind::direction) sight.orientation = network.orientation(r.round);
        sight.v = network.position(r.to) - network.position(r.from);
        sight.v.z() += r.height_to - r.height_from;
        sight.length = r.kind == ReadingKind::slope_distance ? sight.v.norm() : sight.v.head<2>().norm();
        sights_.push_back(sight);
    }
}

void NearPredictions::at_estimates(std::span<const double> x, std::vector<double>& residuals) const {
    residuals.resize(sights_.size());
    for (std::size_t i = 0; i < sights_.size(); ++i) {
        residuals[i] = on_circle(sights_[i].kind, x[i] - predicted_[i]);
    }
}

double NearPredictions::change(const Sight& s, const std::vector<double>& moved) const {
    const Eigen::Map<const Eigen::Vector3d> from(moved.data() + s.from), to(moved.data() + s.to);
    const Eigen::Vector3d v = s.v + (to - from);
    switch (s.kind) {
        case ReadingKind::slope_distance:
            return v.norm() - s.length;
        case ReadingKind::horizontal_distance:
            return v.head<2>().norm() - s.length;
        case ReadingKind::zenith_angle: {
            const double level = v.head<2>().norm();
            return angle_of(level * s.v.z() - s.length * v.z(), level * s.length + v.z() * s.v.z());
        }
        default:
            return sense_ * angle_of(s.v.x() * v.y() - s.v.y() * v.x(), s.v.x() * v.x() + s.v.y() * v.y()) -
                   (s.kind == ReadingKind::direction ? moved[s.orientation] : 0.0);
    }
}

void NearPredictions::at_state(std::span<const double> x, const std::vector<double>& begun,
                               const std::vector<double>& state, const std::vector<double>& moved,
                               std::vector<double>& residuals) const {
    residuals.resize(sights_.size());
    for (std::size_t i = 0; i < sights_.size(); ++i)
        residuals[i] = sights_[i].is_plain ? on_circle(sights_[i].kind, begun[i] - change(sights_[i], moved))
                                           : residual_of(network_, network_.readings[i], x[i], state.data());
}

}  // namespace covaria::network
