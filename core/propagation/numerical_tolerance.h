// Numerical tolerance of a standard uncertainty (JCGM 101 7.9.2).
#pragma once

namespace covaria::detail {

/// z = c * 10^l with c of exactly `digits` decimal digits; the tolerance is 10^l / 2. 0 for z = 0.
double numerical_tolerance(double z, int digits);

}  // namespace covaria::detail
