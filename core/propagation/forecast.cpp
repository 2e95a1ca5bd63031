#include "core/propagation/forecast.h"

#include <algorithm>
#include <cmath>

#include "core/base/name.h"
#include "core/math/normal_quantile.h"
#include "core/propagation/adaptive.h"
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

/// "2 100 000": to two digits, which is more than a forecast knows.
std::string rounded_count(double number) {
    return format_decimals(number, std::min(0, decimals_for(number)));
}

}  // namespace

Message AdaptiveForecast::words() const {
    const std::string unit = output.unit.display();
    const Message name = output.group.empty() ? Message(output.symbol)
                                              : tell<"%1 of %2">(output.symbol, said_name(output.group));
    const auto short_number = [](double value) { return Message::number(format_short(value, 2)); };
    return tell<"a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)">(
        short_number(output.unit.interval_from_si(tolerance)), unit, name,
        short_number(output.unit.interval_from_si(u)), Message::number(rounded_count(trials)),
        Message::number(rounded_count(batches)));
}

std::optional<AdaptiveForecast> forecast_adaptive(const MeasurementModel& model,
                                                  const Propagation& propagation,
                                                  const EvaluationOptions& options) {
    if (options.method != Method::adaptive) return {};
    const auto batch =
        static_cast<double>(detail::AdaptiveProcedure::batch_trials(options.coverage_probability));
    const double factor = 4.0 * std::max(1.0, end_point_variance(options.coverage_probability));
    AdaptiveForecast most;
    for (std::size_t j = 0; j < model.outputs().size(); ++j) {
        const OutputQuantity& output = model.outputs()[j];
        const double u = propagation.law.uncertainty(static_cast<Eigen::Index>(j));
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
