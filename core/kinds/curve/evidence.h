// Points of a calibration as evidence for or against their stated uncertainties.
#pragma once

#include <memory>

#include "core/kinds/curve/fit.h"

namespace covaria::curve {

/// Evidence of the residuals about the stated u of y and of x, along y (to first order in those of x).
/// Null without stated uncertainties, and with correlations stated between single points.
std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const CurveSetup& setup,
                                                                      const Fit& fit);

/// Gives the points the uncertainties that the residuals see, where the set-up asks for it; then the curve is
/// to be fitted anew. The deviations that all points share stay as stated.
void take_as_seen(CurveSetup& setup, const evidence::RedundantReadings* readings, Problems& problems);

}  // namespace covaria::curve
