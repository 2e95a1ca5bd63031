// A smooth function of the normal score z, tabulated once as piecewise polynomials: fast quantiles of
// distributions whose inverse distribution function is slow.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace covaria::detail {

class NormalScoreTable {
public:
    /// Scores of probabilities from 2^-53 to 1 - 2^-53 lie within +-8.21.
    static constexpr double largest_score = 8.25;

    struct Domain {
        double low;     ///< scores
        double high;    ///< scores
        bool relative;  ///< the tolerance is relative to the value
    };

    /// Chebyshev interpolation in equal intervals, halved until the interpolant agrees with `function` to
    /// `tolerance` between its nodes. Null if that is never reached or a value is not finite.
    static std::shared_ptr<const NormalScoreTable> build(const std::function<double(double)>& function,
                                                         const Domain& domain, double tolerance);

    /// Value at `z`, which must lie in the domain.
    double operator()(double z) const {
        const double s = (z - low_) * intervals_per_unit_;
        const std::size_t interval = std::min(static_cast<std::size_t>(s), pieces_.size() - 1);
        const double t = 2.0 * (s - static_cast<double>(interval)) - 1.0;
        const Piece& c = pieces_[interval];
        double sum = c[order - 1];
        for (std::size_t k = order - 1; k-- > 0;) sum = std::fma(sum, t, c[k]);
        return sum;
    }

private:
    static constexpr std::size_t order = 8;  ///< coefficients of one interval: a cache line
    using Piece = std::array<double, order>;

    NormalScoreTable(double low, double high, std::size_t intervals);
    static Piece fitted(const std::array<double, order>& values);
    bool fill(const std::function<double(double)>& function, const Domain& domain, double tolerance);
    double score(std::size_t interval, double t) const;

    double low_;
    double intervals_per_unit_;
    std::vector<Piece> pieces_;
};

}  // namespace covaria::detail
