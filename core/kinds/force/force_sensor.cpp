#include "core/kinds/force/force_sensor.h"

#include <cmath>

namespace covaria {

double ForceChannel::s_single(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? s_pooled : std::sqrt(runs) * u_a;
}

double ForceChannel::s_degrees_of_freedom(bool pooled) const {
    return pooled && pooled_degrees_of_freedom > 0.0 ? pooled_degrees_of_freedom : degrees_of_freedom;
}

}  // namespace covaria
