#include "core/propagation/guard_band.h"

#include <algorithm>
#include <cmath>

namespace covaria {

namespace {

/// Half of the tolerance; infinite where a limit is missing.
double half_tolerance(const OutputRequirement& r) {
    return r.lower_limit && r.upper_limit ? 0.5 * (*r.upper_limit - *r.lower_limit) : infinity;
}

double band_of_ratio(GuardRule rule, double half, double U) {
    if (!(U > 0.0)) return 0.0;
    if (rule == GuardRule::rss) return U >= half ? half : U * (U / (half + std::sqrt(half * half - U * U)));
    if (rule == GuardRule::rp10) return std::max(0.0, U - 0.25 * half);
    return std::max(0.0, U * (1.04 - std::exp(0.38 * std::log(half / U) - 0.54)));
}

/// The least w in [0, most] at which a risk that falls with w meets the target. Between two limits the
/// interval of acceptance ends in its middle; from one limit w is sought as far as it takes.
double least_band(const std::function<double(double)>& risk, double target, double most, double start) {
    if (risk(0.0) <= target) return 0.0;
    double low = 0.0, high = std::min(most, start);
    while (high < most && risk(high) > target) {
        low = high;
        high = std::min(most, 2.0 * high);
        if (!std::isfinite(high) || high > 1e9 * start) return infinity;
    }
    if (risk(high) > target) return infinity;
    for (int step = 0; step < 100 && high - low > 1e-12 * high; ++step) {
        const double middle = 0.5 * (low + high);
        (risk(middle) > target ? low : high) = middle;
    }
    return high;
}

double specific_risk(const OutputRequirement& r, const GuardBandBasis& basis, double w) {
    double risk = 0.0;
    if (r.lower_limit) risk = std::max(risk, basis.nonconforming_at(*r.lower_limit + w));
    if (r.upper_limit) risk = std::max(risk, basis.nonconforming_at(*r.upper_limit - w));
    return risk;
}

double risk_for_prior(const OutputRequirement& r, double u, double w) {
    const ToleranceLimits limits{r.lower_limit.value_or(-infinity), r.upper_limit.value_or(infinity),
                                 r.lower_limit.value_or(-infinity) + w, r.upper_limit.value_or(infinity) - w};
    const auto risks = global_risks(limits, *r.prior_mean, *r.prior_standard_deviation, u);
    return r.guard_rule == GuardRule::global_risk ? risks.consumer : risks.consumer_if_accepted;
}

}  // namespace

double guard_band_of(const OutputRequirement& r, const GuardBandBasis& basis) {
    const double half = half_tolerance(r), u = basis.standard_uncertainty;
    if (r.guard_rule == GuardRule::factor) return r.guard_factor * basis.expanded_uncertainty;
    if (is_of_ratio(r.guard_rule)) return band_of_ratio(r.guard_rule, half, basis.expanded_uncertainty);
    if (!(u > 0.0) || !std::isfinite(u)) return u > 0.0 ? infinity : 0.0;
    if (r.guard_rule == GuardRule::specific_risk)
        return least_band([&](double w) { return specific_risk(r, basis, w); }, r.target_risk, half, u);
    if (!r.prior_mean || !r.prior_standard_deviation) return infinity;
    return least_band([&](double w) { return risk_for_prior(r, u, w); }, r.target_risk, half, u);
}

}  // namespace covaria
