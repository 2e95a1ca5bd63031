// Guard bands by the name of their rule, and to a target risk.
#pragma once

#include <functional>

#include "core/propagation/requirements.h"

namespace covaria {

/// Basis of a guard band.
struct GuardBandBasis {
    double expanded_uncertainty = 0.0;
    double standard_uncertainty = 0.0;
    /// Probability that the measurand lies outside the tolerance where the result is this value: the
    /// distribution of the result, moved there.
    std::function<double(double)> nonconforming_at;
};

/// w of the requirement's rule; infinite: nothing can be accepted. A rule that asks for a target risk has the
/// least w, not negative, that meets it.
double guard_band_of(const OutputRequirement& requirement, const GuardBandBasis& basis);

}  // namespace covaria
