#include "core/kinds/curve/polynomials.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace covaria::curve {

namespace {

using Column = std::vector<long double>;

class Arnoldi {
public:
    Arnoldi(Polynomials& made, std::span<const double> x, std::span<const double> weights)
        : made_(made), weights_(weights) {
        for (const double one : x)
            t_.push_back((static_cast<long double>(one) - made.centre) / made.half_width);
    }

    bool run() {
        if (!start()) return false;
        for (std::size_t k = 0; k + 1 < made_.count; ++k)
            if (!extend(k)) return false;
        return true;
    }

private:
    long double product(const Column& a, const Column& b) const {
        long double sum = 0.0L;
        for (std::size_t i = 0; i < a.size(); ++i) sum += weights_[i] * a[i] * b[i];
        return sum / static_cast<long double>(a.size());
    }

    bool start() {
        Column phi(t_.size(), 1.0L);
        for (std::size_t i = 0; i < phi.size() && made_.zero; ++i) phi[i] = t_[i] - *made_.zero;
        const long double norm = std::sqrt(product(phi, phi));
        if (!(norm > 0.0L)) return false;
        made_.first = static_cast<double>(1.0L / norm);
        for (long double& value : phi) value *= made_.first;
        columns_.push_back(std::move(phi));
        return true;
    }

    /// The polynomials are those of the rounded coefficients: every other computation uses the same.
    bool extend(std::size_t k) {
        Column next(t_.size());
        for (std::size_t i = 0; i < next.size(); ++i) next[i] = t_[i] * columns_[k][i];
        const long double before = std::sqrt(product(next, next));
        Column reduced = next;
        for (int pass = 0; pass < 2; ++pass)
            for (std::size_t j = 0; j <= k; ++j) {
                const long double h = product(columns_[j], reduced);
                made_.recurrence[k][j] = static_cast<double>(made_.recurrence[k][j] + h);
                for (std::size_t i = 0; i < reduced.size(); ++i) reduced[i] -= h * columns_[j][i];
            }
        for (std::size_t j = 0; j <= k; ++j)
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] -= static_cast<long double>(made_.recurrence[k][j]) * columns_[j][i];
        const long double norm = std::sqrt(product(next, next));
        if (!(norm > 1e-13L * before)) return false;
        made_.factor[k] = static_cast<double>(1.0L / norm);
        for (long double& value : next) value *= made_.factor[k];
        columns_.push_back(std::move(next));
        return true;
    }

    Polynomials& made_;
    std::span<const double> weights_;
    Column t_;
    std::vector<Column> columns_;
};

}  // namespace

std::optional<Polynomials> orthonormal_polynomials(std::span<const double> x, std::span<const double> weights,
                                                   std::size_t count, std::optional<double> zero_at) {
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    Polynomials made;
    made.count = count;
    made.centre = 0.5 * (*low + *high);
    made.half_width = 0.5 * (*high - *low);
    if (!(made.half_width > 0.0))
        made.half_width = std::max(std::abs(made.centre - zero_at.value_or(0.0)), 1e-300);
    if (zero_at) made.zero = made.t_of(*zero_at);
    if (!Arnoldi(made, x, weights).run()) return std::nullopt;
    return made;
}

}  // namespace covaria::curve
