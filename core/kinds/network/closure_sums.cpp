#include "core/kinds/network/closure_sums.h"

#include <algorithm>
#include <cmath>

namespace covaria::network {

ClosureSums::ClosureSums(const AdjustedNetwork& of) : network(of), stated_(of.figures.size(), none) {
    for (const ReadingCorrelation& c : of.correlations)
        correlations_[std::minmax(c.first, c.second)] = c.coefficient;
    values_.reserve(of.readings.size());
    for (std::size_t i = 0; i < of.readings.size(); ++i) {
        const AdjustedReading& r = of.readings[i];
        values_.push_back(r.value);
        const bool states = r.kind == ReadingKind::figure_length || r.kind == ReadingKind::figure_ratio ||
                            r.kind == ReadingKind::figure_angle;
        if (states && r.frame == AdjustedReading::no_frame) stated_[r.figures.front()] = i;
    }
}

double ClosureSums::u_of(const std::vector<SignedReading>& readings) const {
    double u2 = 0.0;
    const auto u = [&](const SignedReading& r) { return r.sign * network.readings[r.reading].u; };
    for (std::size_t i = 0; i < readings.size(); ++i) {
        u2 += u(readings[i]) * u(readings[i]);
        if (correlations_.empty()) continue;
        for (std::size_t k = 0; k < i; ++k)
            if (const auto found = correlations_.find(std::minmax(readings[i].reading, readings[k].reading));
                found != correlations_.end())
                u2 += 2.0 * found->second * u(readings[i]) * u(readings[k]);
    }
    return std::sqrt(std::fmax(0.0, u2));
}

void ClosureSums::add(Message words, const std::vector<SignedReading>& readings, double misclosure) {
    const double u = u_of(readings);
    if (!(u > 0.0)) return;
    const AdjustedReading& last = network.readings[readings.back().reading];
    Closure closure{std::move(words), misclosure, u, unit_of_residual(last.kind), last.source, {}};
    for (const SignedReading& r : readings)
        if (const std::size_t row = network.readings[r.reading].row; row != AdjustedReading::no_round)
            closure.rows.push_back(row);
    std::ranges::sort(closure.rows);
    closure.rows.erase(std::ranges::unique(closure.rows).begin(), closure.rows.end());
    found_.push_back(std::move(closure));
}

void ClosureSums::add(Message words, const std::vector<std::size_t>& readings,
                      const std::function<double(const Values&)>& function) {
    const double misclosure = function(values_);
    if (!std::isfinite(misclosure)) return;
    std::vector<SignedReading> signs;
    for (const std::size_t i : readings) {
        const double value = values_[i], u = network.readings[i].u;
        values_[i] = value + u;
        const double above = function(values_);
        values_[i] = value - u;
        const double below = function(values_);
        values_[i] = value;
        if (!std::isfinite(above) || !std::isfinite(below)) return;
        signs.push_back({i, (above - below) / (2.0 * u)});
    }
    add(std::move(words), signs, misclosure);
}

std::vector<Closure> ClosureSums::take() {
    std::ranges::stable_sort(found_,
                             [](const Closure& a, const Closure& b) { return a.ratio() > b.ratio(); });
    return std::move(found_);
}

}  // namespace covaria::network
