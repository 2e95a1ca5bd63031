#include "core/propagation/forecast.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/propagation/adaptive.h"
#include "core/propagation/first_order.h"
#include "core/propagation/numerical_tolerance.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

/// Variance of an end point of the interval times n, for u = 1.
double end_point_variance(double probability) {
    const double q = (1.0 + probability) / 2.0;
    const double density = normal_density(normal_quantile(q));
    return q * (1.0 - q) / (density * density);
}

}  // namespace

std::string AdaptiveForecast::words() const {
    const std::string unit = output.unit.display();
    return "a tolerance of " + format_short(output.unit.interval_from_si(tolerance), 2) + " " + unit +
           " for " + output.symbol + (output.group.empty() ? "" : " of " + output.group) +
           " (u = " + format_short(output.unit.interval_from_si(u), 2) + " " + unit + ") needs about " +
           format_short(trials, 2) + " trials (" + format_short(batches, 2) + " batches)";
}

std::optional<AdaptiveForecast> forecast_adaptive(const MeasurementModel& model, const InputSet& inputs,
                                                  const EvaluationOptions& options) {
    if (options.method != Method::adaptive) return {};
    const auto correlations = resolved_correlations(inputs);
    if (!correlations) return {};
    const auto law = detail::law_of_propagation(model, inputs, *correlations);
    if (!law) return {};
    const auto batch =
        static_cast<double>(detail::AdaptiveProcedure::batch_trials(options.coverage_probability));
    const double factor = 4.0 * std::max(1.0, end_point_variance(options.coverage_probability));
    AdaptiveForecast most;
    for (std::size_t j = 0; j < model.outputs().size(); ++j) {
        const OutputQuantity& output = model.outputs()[j];
        const double u = law->uncertainty(static_cast<Eigen::Index>(j));
        const double delta =
            options.tolerance_for(output.unit)
                .value_or(detail::numerical_tolerance(u, output.unit, options.significant_digits));
        if (output.role != OutputRole::measurand || !(u > 0.0) || !(delta > 0.0)) continue;
        const double trials = factor * (u / delta) * (u / delta);
        if (trials > most.trials) most = {trials, 0.0, output, delta, u};
    }
    most.trials = std::max(most.trials, batch * static_cast<double>(options.minimum_batches));
    most.batches = std::ceil(most.trials / batch);
    return most.u > 0.0 ? std::optional(most) : std::nullopt;
}

}  // namespace covaria
