#include "core/result/trial_distribution.h"

#include <algorithm>

namespace covaria {

double TrialDistribution::up_to(double limit) const {
    if (values.empty() || limit < values.front()) return 0.0;
    if (limit >= values.back()) return 1.0;
    const auto after = std::upper_bound(values.begin(), values.end(), limit);
    const auto i = static_cast<std::size_t>(after - values.begin());
    const double part = (limit - values[i - 1]) / (values[i] - values[i - 1]);
    return shares[i - 1] + part * (shares[i] - shares[i - 1]);
}

double TrialDistribution::below(double limit) const {
    if (values.empty() || limit <= values.front()) return 0.0;
    if (limit > values.back()) return 1.0;
    const auto at = std::lower_bound(values.begin(), values.end(), limit);
    const auto i = static_cast<std::size_t>(at - values.begin());
    const double part = (limit - values[i - 1]) / (values[i] - values[i - 1]);
    return shares[i - 1] + part * (shares[i] - shares[i - 1]);
}

double TrialDistribution::inside(double low, double high) const {
    return std::clamp(up_to(high) - below(low), 0.0, 1.0);
}

}  // namespace covaria
