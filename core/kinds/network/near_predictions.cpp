#include "core/kinds/network/near_predictions.h"

namespace covaria::network {

namespace {

bool is_sight(ReadingKind kind) {
    return kind == ReadingKind::slope_distance || kind == ReadingKind::horizontal_distance ||
           kind == ReadingKind::direction || kind == ReadingKind::azimuth ||
           kind == ReadingKind::zenith_angle;
}

}  // namespace

NearPredictions::NearPredictions(const AdjustedNetwork& network) : sense_(network.clockwise ? -1.0 : 1.0) {
    sights_.reserve(network.readings.size());
    for (const AdjustedReading& r : network.readings) {
        Sight sight{.kind = r.kind,
                    .is_angle = is_of_angle(r.kind),
                    .from = static_cast<unsigned>(3 * r.from),
                    .to = static_cast<unsigned>(3 * r.to),
                    .predicted = predicted(network, r, network.state.data())};
        sight.is_plain = is_sight(r.kind) && r.figures.empty() && r.tilt == AdjustedReading::no_tilt &&
                         (network.curvature == 0.0 || r.kind != ReadingKind::zenith_angle);
        are_all_plain_ = are_all_plain_ && sight.is_plain;
        if (r.kind == ReadingKind::direction)
            sight.orientation = static_cast<unsigned>(network.orientation(r.round));
        sight.v = network.position(r.to) - network.position(r.from);
        sight.v.z() += r.height_to - r.height_from;
        sight.length = r.kind == ReadingKind::slope_distance ? sight.v.norm() : sight.v.head<2>().norm();
        sights_.push_back(sight);
    }
}

}  // namespace covaria::network
