// Type A evaluation: means, experimental standard deviations and covariances of repeated observations.
#include "core/quantity/type_a.h"

#include <algorithm>
#include <cmath>

namespace covaria {

namespace {

double mean_of(std::span<const double> values) {
    // Relative to the first value: lengths of metres that differ by micrometres keep their digits.
    double sum = 0.0;
    for (const double v : values) sum += v - values.front();
    return values.front() + sum / static_cast<double>(values.size());
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

Result<TypeA> type_a_evaluation(std::span<const double> observations) {
    if (observations.size() < 2)
        return fail(ErrorCode::bad_input, tell<"a Type A evaluation needs at least two observations.">());
    if (!all_finite(observations))
        return fail(ErrorCode::bad_input, tell<"one of the observations is not a finite number.">());
    const double n = static_cast<double>(observations.size());
    TypeA result;
    result.mean = mean_of(observations);
    double squares = 0.0;
    for (const double v : observations) squares += (v - result.mean) * (v - result.mean);
    result.degrees_of_freedom = n - 1.0;
    result.standard_deviation = std::sqrt(squares / (n - 1.0));
    result.standard_uncertainty = result.standard_deviation / std::sqrt(n);
    return result;
}

Result<PooledDeviation> pooled_deviation(std::span<const std::vector<double>> series) {
    if (series.empty()) return fail(ErrorCode::bad_input, tell<"there is no series to be pooled.">());
    PooledDeviation pooled;
    double squares = 0.0;
    for (const std::vector<double>& observations : series) {
        const auto one = type_a_evaluation(observations);
        if (!one) return fail(one.error());
        squares += one->degrees_of_freedom * one->standard_deviation * one->standard_deviation;
        pooled.degrees_of_freedom += one->degrees_of_freedom;
    }
    pooled.standard_deviation = std::sqrt(squares / pooled.degrees_of_freedom);
    return pooled;
}

Result<double> covariance_of_means(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size())
        return fail(ErrorCode::bad_input, tell<"the covariance of two means needs observations made in "
                                               "pairs: the series have different lengths.">());
    if (x.size() < 2)
        return fail(ErrorCode::bad_input, tell<"the covariance of two means needs at least two pairs.">());
    if (!all_finite(x) || !all_finite(y))
        return fail(ErrorCode::bad_input, tell<"one of the observations is not a finite number.">());
    const double n = static_cast<double>(x.size());
    const double x_mean = mean_of(x);
    const double y_mean = mean_of(y);
    double products = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) products += (x[i] - x_mean) * (y[i] - y_mean);
    return products / (n * (n - 1.0));
}

}  // namespace covaria
