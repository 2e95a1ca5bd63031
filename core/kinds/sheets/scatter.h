// Components of uncertainty that follow from the scatter of readings.
#pragma once

#include <cmath>
#include <string>

#include "core/quantity/input_quantity.h"

namespace covaria::sheets {

/// JCGM 100 E.4.3: an s of normal readings has a relative standard deviation of about 1/sqrt(2 nu).
inline double u_of_deviation(double s, double degrees_of_freedom) {
    return s / std::sqrt(2.0 * degrees_of_freedom);
}

/// The Type A component of an estimate from residuals: t with their degrees of freedom.
UncertaintyComponent residual_component(std::string id, const Unit& unit, double u, double degrees_of_freedom,
                                        Message name, Message origin);
/// The component of a standard deviation s itself.
UncertaintyComponent deviation_component(std::string id, const Unit& unit, double s,
                                         double degrees_of_freedom, Message origin);

}  // namespace covaria::sheets
