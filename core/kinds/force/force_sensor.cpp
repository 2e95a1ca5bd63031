#include "core/kinds/force/force_sensor.h"

#include <cmath>

namespace covaria {

std::size_t axis_index(const std::string& key) {
    std::size_t axis = 0;
    while (axis + 1 < most_channels && key != force_axes[axis].key) ++axis;
    return axis;
}

double ForceChannel::s_single(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? s_pooled : std::sqrt(runs) * u_a;
}

double ForceChannel::s_degrees_of_freedom(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? pooled_degrees_of_freedom : degrees_of_freedom;
}

}  // namespace covaria
