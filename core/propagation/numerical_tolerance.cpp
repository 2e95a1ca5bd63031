// Numerical tolerance of a standard uncertainty.
#include "core/propagation/numerical_tolerance.h"

#include <cmath>

namespace covaria::detail {

double numerical_tolerance(double z, int digits) {
    z = std::abs(z);
    if (!(z > 0) || !std::isfinite(z)) return 0.0;
    int l = static_cast<int>(std::floor(std::log10(z))) - (digits - 1);
    const double c = std::round(z / std::pow(10.0, l));
    if (c >= std::pow(10.0, digits)) ++l;  // 0.0996 with two digits is 10 * 10^-2
    return 0.5 * std::pow(10.0, l);
}

double numerical_tolerance(double z, const Unit& unit, int digits) {
    return unit.interval_to_si(numerical_tolerance(unit.interval_from_si(z), digits));
}

}  // namespace covaria::detail
