// Quantile functions that look for a step: histograms, and the tables of Poisson and binomial distributions.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/quantity/quantile_function.h"

namespace covaria::detail {

namespace {

/// Below it nothing is ever drawn: uniform numbers have 53 bits.
constexpr double never = 1e-22;

/// Probabilities from the most probable number outwards by the ratio of neighbours, which never overflows:
/// `up(n)` is P(n + 1)/P(n). DiscreteQuantile makes the sum one.
template <class Up>
Discrete outwards(double mode, double most, double step, double zero, Up up) {
    std::vector<double> below;
    double probability = 1.0;
    for (double n = mode; n > 0.0 && probability > never; n -= 1.0)
        below.push_back(probability /= up(n - 1.0));
    Discrete table;
    const auto add = [&](double n, double p) {
        table.values.push_back(zero + step * n);
        table.probabilities.push_back(p);
    };
    for (std::size_t i = below.size(); i-- > 0;) add(mode - static_cast<double>(i) - 1.0, below[i]);
    add(mode, probability = 1.0);
    for (double n = mode; n < most && probability > never; n += 1.0) add(n + 1.0, probability *= up(n));
    double sum = 0.0;
    for (const double p : table.probabilities) sum += p;
    for (double& p : table.probabilities) p /= sum;
    return table;
}

class HistogramQuantile final : public QuantileFunction {
public:
    explicit HistogramQuantile(const StatedHistogram& h) {
        double sum = 0.0, whole = 0.0;
        for (const double probability : h.probabilities) whole += probability;
        for (std::size_t i = 0; i < h.probabilities.size(); ++i) {
            if (h.probabilities[i] == 0.0) continue;
            const double width = h.edges[i + 1] - h.edges[i], part = h.probabilities[i] / whole;
            cells_.push_back({h.edges[i], h.edges[i + 1], sum, width / part});
            sum += part;
            cumulative_.push_back(sum);
        }
    }

    void at(std::span<const double> p, std::span<double> x) const override {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto place = std::lower_bound(cumulative_.begin(), cumulative_.end() - 1, p[i]);
            const Cell& cell = cells_[static_cast<std::size_t>(place - cumulative_.begin())];
            x[i] = std::clamp(cell.low + cell.slope * (p[i] - cell.below), cell.low, cell.high);
        }
    }

private:
    struct Cell {
        double low, high;
        double below;  ///< probability
        double slope;  ///< slope of the quantile
    };
    std::vector<Cell> cells_;         ///< cells that have a probability
    std::vector<double> cumulative_;  ///< probabilities up to their ends, rising to 1
};

}  // namespace

Discrete table_of(const Poisson& p) {
    if (p.step == 0.0 || p.number == 0.0) return {{p.zero}, {1.0}};
    return outwards(std::floor(p.number), infinity, p.step, p.zero,
                    [&](double n) { return p.number / (n + 1.0); });
}

Discrete table_of(const Binomial& b) {
    if (b.step == 0.0 || b.probability == 0.0) return {{b.zero}, {1.0}};
    if (b.probability == 1.0) return {{b.zero + b.step * b.trials}, {1.0}};
    const double odds = b.probability / (1.0 - b.probability);
    const double mode = std::min(std::floor((b.trials + 1.0) * b.probability), b.trials);
    return outwards(mode, b.trials, b.step, b.zero,
                    [&](double n) { return (b.trials - n) / (n + 1.0) * odds; });
}

QuantileFunctionPointer make_histogram(const StatedHistogram& parameters) {
    return std::make_shared<HistogramQuantile>(parameters);
}

}  // namespace covaria::detail

namespace covaria {

Discrete values_with_probabilities(const Distribution& distribution) {
    Discrete made;
    if (const auto* d = std::get_if<Discrete>(&distribution.parameters())) made = *d;
    if (const auto* p = std::get_if<Poisson>(&distribution.parameters())) made = detail::table_of(*p);
    if (const auto* b = std::get_if<Binomial>(&distribution.parameters())) made = detail::table_of(*b);
    return made;
}

}  // namespace covaria
