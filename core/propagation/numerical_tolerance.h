// Numerical tolerance of a standard uncertainty (JCGM 101 7.9.2).
#pragma once

#include "core/base/unit.h"

namespace covaria::detail {

/// z = c * 10^l with c of exactly `digits` decimal digits; the tolerance is 10^l / 2. 0 for z = 0.
double numerical_tolerance(double z, int digits);

/// Tolerance of a z in SI that is reported in `unit`: the digits that count are those of the reported number.
double numerical_tolerance(double z, const Unit& unit, int digits);

}  // namespace covaria::detail
