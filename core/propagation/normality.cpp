// Normality verdict in words.
#include "core/propagation/normality.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"

namespace covaria::detail {
namespace {

constexpr double close = 0.01;  // as parts of the width of the interval
constexpr double tolerable = 0.05;
constexpr double certain_z = 5.0;  // standard errors of a moment that chance does not explain

/// Standard error of (q_high - q_low)/(2 k u) under normality, relative.
double scatter_of_ratio(double trials, double probability, double k) {
    const double tail = (1.0 - probability) / 2.0;
    const double density = normal_density(k);
    return std::sqrt(tail * (1.0 - tail) / trials / 2.0) / density / k;
}

}  // namespace

NormalityVerdict normality_of(const MonteCarloOutput& output, std::uint64_t trials, double probability) {
    NormalityVerdict verdict;
    const double u = output.standard_uncertainty;
    if (!(u > 0) || trials < 2) {
        verdict.words = tell<"no spread">();
        return verdict;
    }
    const auto n = static_cast<double>(trials);
    const double k = -normal_quantile(0.5 * (1.0 - probability));
    verdict.skewness_z = output.skewness / std::sqrt(6.0 / n);
    verdict.kurtosis_z = output.kurtosis / std::sqrt(24.0 / n);
    const CoverageInterval& interval = output.symmetric;
    verdict.coverage_ratio = (interval.high - interval.low) / (2.0 * k * u);
    const double asymmetry = (interval.high + interval.low - 2.0 * output.mean) / (2.0 * k * u);
    const double deviation = std::max(std::abs(verdict.coverage_ratio - 1.0), std::abs(asymmetry));
    const double noise = 3.0 * scatter_of_ratio(n, probability, k);
    verdict.acceptable = deviation <= tolerable + noise;
    const bool other_shape = std::max(std::abs(verdict.skewness_z), std::abs(verdict.kurtosis_z)) > certain_z;
    if (deviation <= std::max(close, noise))
        verdict.words = noise <= close ? tell<"normal within 1 %">()
                        : other_shape  ? tell<"not normal; k u fits as far as so few trials can tell">()
                                       : tell<"normal as far as so few trials can tell">();
    else if (verdict.acceptable)
        verdict.words = tell<"normal within 5 %">();
    else if (std::abs(asymmetry) > std::abs(verdict.coverage_ratio - 1.0))
        verdict.words = tell<"too skewed for k u">();
    else if (output.kurtosis > 0)
        verdict.words = tell<"too heavy-tailed for k u">();
    else
        verdict.words = tell<"too flat for k u">();
    return verdict;
}

}  // namespace covaria::detail
