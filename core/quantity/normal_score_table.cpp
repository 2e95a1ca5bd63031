// Building of tables over the normal score.
#include "core/quantity/normal_score_table.h"

#include <numbers>

namespace covaria::detail {

namespace {

constexpr std::size_t fewest_intervals = 32;
constexpr std::size_t most_intervals = 1024;

}  // namespace

NormalScoreTable::NormalScoreTable(double low, double high, std::size_t intervals)
    : low_(low), intervals_per_unit_(static_cast<double>(intervals) / (high - low)), pieces_(intervals) {}

double NormalScoreTable::score(std::size_t interval, double t) const {
    return low_ + (static_cast<double>(interval) + 0.5 * (t + 1.0)) / intervals_per_unit_;
}

/// Coefficients of powers of t from the values at the Chebyshev nodes cos(pi (i + 1/2)/n).
NormalScoreTable::Piece NormalScoreTable::fitted(const std::array<double, order>& values) {
    constexpr double n = order;
    Piece powers{};
    Piece previous{1.0};      // T_0
    Piece current{0.0, 1.0};  // T_1
    for (std::size_t k = 0; k < order; ++k) {
        double sum = 0.0;
        for (std::size_t i = 0; i < order; ++i)
            sum += values[i] *
                   std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
        const double coefficient = sum * (k == 0 ? 1.0 : 2.0) / n;
        for (std::size_t j = 0; j < order; ++j) powers[j] += coefficient * previous[j];
        Piece next{};  // T_(k+2) = 2 t T_(k+1) - T_k
        for (std::size_t j = 0; j + 1 < order; ++j) next[j + 1] = 2.0 * current[j];
        for (std::size_t j = 0; j < order; ++j) next[j] -= previous[j];
        previous = current;
        current = next;
    }
    return powers;
}

bool NormalScoreTable::fill(const std::function<double(double)>& function, const Domain& domain,
                            double tolerance) {
    for (std::size_t interval = pieces_.size(); interval-- > 0;) {  // from the end, where it is hardest
        std::array<double, order> values;
        for (std::size_t i = 0; i < order; ++i) {
            const double t = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / order);
            values[i] = function(score(interval, t));
            if (!std::isfinite(values[i])) return false;
        }
        pieces_[interval] = fitted(values);
        for (const double t : {-0.92388, 0.38268}) {  // between the nodes, where the deviation is largest
            const double z = score(interval, t);
            const double expected = function(z);
            const double allowed = tolerance * (domain.relative ? std::abs(expected) : 1.0);
            if (!(std::abs((*this)(z)-expected) <= allowed)) return false;
        }
    }
    return true;
}

std::shared_ptr<const NormalScoreTable> NormalScoreTable::build(const std::function<double(double)>& function,
                                                                const Domain& domain, double tolerance) {
    for (std::size_t intervals = fewest_intervals; intervals <= most_intervals; intervals *= 2) {
        const std::shared_ptr<NormalScoreTable> table(
            new NormalScoreTable(domain.low, domain.high, intervals));
        if (table->fill(function, domain, tolerance)) return table;
    }
    return nullptr;
}

}  // namespace covaria::detail
