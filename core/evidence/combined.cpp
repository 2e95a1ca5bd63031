#include "core/evidence/combined.h"

#include <algorithm>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>

namespace covaria::evidence {

namespace {

constexpr double most_degrees_of_freedom = 1e8;  ///< beyond them a u counts as known
constexpr int most_halvings = 200;

struct LogVariance {
    double value = 0.0;     ///< unbiased for ln sigma^2
    double variance = 0.0;  ///< of the estimate
};

double bias_of_log(double degrees_of_freedom) {
    const double half = 0.5 * std::min(degrees_of_freedom, most_degrees_of_freedom);
    return boost::math::digamma(half) - std::log(half);
}

LogVariance log_variance_of(const CampaignFigure& figure) {
    const double nu = std::min(figure.degrees_of_freedom, most_degrees_of_freedom);
    return {2.0 * std::log(figure.u) - bias_of_log(nu), boost::math::trigamma(0.5 * nu)};
}

struct WeightedMean {
    double mean = 0.0, weights = 0.0, squares = 0.0;
};

WeightedMean mean_with(const std::vector<LogVariance>& campaigns, double between) {
    WeightedMean found;
    for (const LogVariance& one : campaigns) {
        const double weight = 1.0 / (one.variance + between);
        found.weights += weight;
        found.mean += weight * (one.value - campaigns.front().value);
    }
    found.mean = campaigns.front().value + found.mean / found.weights;
    for (const LogVariance& one : campaigns)
        found.squares += std::pow(one.value - found.mean, 2) / (one.variance + between);
    return found;
}

/// tau^2 at which the weighted sum of squares is that of K - 1 degrees of freedom; it falls with tau^2.
double between_of(const std::vector<LogVariance>& campaigns) {
    const double expected = static_cast<double>(campaigns.size()) - 1.0;
    if (mean_with(campaigns, 0.0).squares <= expected) return 0.0;
    double low = 0.0, high = 1.0;
    while (mean_with(campaigns, high).squares > expected) high *= 2.0;
    for (int k = 0; k < most_halvings && high - low > 1e-15 * high; ++k) {
        const double middle = 0.5 * (low + high);
        (mean_with(campaigns, middle).squares > expected ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// x with psi'(x) = `value`, by Newton's method on its reciprocal, which is nearly linear (Smyth 2004).
double inverse_trigamma(double value) {
    double x = 0.5 + 1.0 / value;
    for (int step = 0; step < 50; ++step) {
        const double at = boost::math::trigamma(x);
        const double change = at * (1.0 - at / value) / boost::math::polygamma(2, x);
        x += change;
        if (std::abs(change) < 1e-14 * x) break;
    }
    return x;
}

}  // namespace

CombinedFigure combined(const std::vector<CampaignFigure>& campaigns) {
    if (campaigns.size() == 1) return {campaigns.front().u, campaigns.front().degrees_of_freedom, 0.0};
    std::vector<LogVariance> logs;
    for (const CampaignFigure& figure : campaigns) logs.push_back(log_variance_of(figure));
    const double between = between_of(logs);
    const WeightedMean mean = mean_with(logs, between);
    const double nu = 2.0 * inverse_trigamma(1.0 / mean.weights + between);
    return {std::exp(0.5 * (mean.mean + bias_of_log(nu))), nu, 0.5 * std::sqrt(between)};
}

}  // namespace covaria::evidence
