// Forecast of the number of trials that the adaptive procedure will need, before it runs.
#pragma once

#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/model/measurement_model.h"
#include "core/propagation/options.h"
#include "core/propagation/propagated.h"

namespace covaria {

struct AdaptiveForecast {
    double trials = 0.0;
    double batches = 0.0;
    OutputQuantity output;   ///< output that needs most
    double tolerance = 0.0;  ///< delta of that output, SI
    double u = 0.0;          ///< standard uncertainty of that output, first order, SI
    /// "a tolerance of 0.0001 mm for X of zero (u = 1.37 mm) needs about 5.3e9 trials (5.3e5 batches)".
    Message words() const;
};

/// Trials until twice the standard deviation of mean, u and end points between batches is below delta, for
/// normally distributed outputs with the u of the law of propagation. The end points of the coverage interval
/// govern: var = q(1 − q)/(n phi(z)²) u², q = (1 + p)/2. Empty: another method.
std::optional<AdaptiveForecast> forecast_adaptive(const MeasurementModel& model,
                                                  const Propagation& propagation,
                                                  const EvaluationOptions& options);

}  // namespace covaria
