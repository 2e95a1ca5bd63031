#include "core/kinds/force/force_sensor.h"

#include <cmath>

namespace covaria {

double ForceChannel::s_single(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? s_pooled : std::sqrt(runs) * u_a;
}

double ForceChannel::s_degrees_of_freedom(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? pooled_degrees_of_freedom : degrees_of_freedom;
}

Layout layout_for_loads(const Offered<ForceSensorSource>& sensor) {
    Layout layout = sensor.asset->layout();
    for (LayoutFrame& frame : layout.frames) frame.source = {};
    layout.points.push_back({.name = "", .p_W = sensor->placement().translation()});
    // The axes of the picture are those of the world.
    if (!sensor->placement().isApprox(Eigen::Isometry3d::Identity()))
        layout.notes.push_back(tell<"results: in the frame of the sensor">());
    return layout;
}

}  // namespace covaria
