#include "core/math/points_from_distances.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "core/math/plane_of_points.h"

namespace covaria {

namespace {

using Places = Eigen::Matrix3Xd;

/// The misfit whose squares are summed.
enum class Misfit {
    of_squares,  ///< (s² − d²)/2d: a polynomial, smooth where points meet, which more beginnings lead down
    of_lengths,  ///< (s − d)/u
};

/// A search for the least sum of squares by damped Gauss-Newton steps (Levenberg-Marquardt).
class DistanceSearch {
public:
    explicit DistanceSearch(const PointsAndDistances& given) : given_(given) {
        unknown_.setConstant(3, static_cast<Eigen::Index>(given.places.size()), -1);
        for (std::size_t p = 0; p < given.places.size(); ++p)
            for (std::size_t c = 0; c < 3; ++c)
                if (!given.holds[p][c])
                    unknown_(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(p)) = unknowns_++;
    }

    bool is_held(Eigen::Index axis, Eigen::Index point) const { return unknown_(axis, point) < 0; }

    Eigen::Index unknowns() const { return unknowns_; }

    /// Moves the places to a least sum nearby, and gives it.
    double settle(Places& x, Misfit misfit) const {
        constexpr int most_steps = 60;
        Eigen::MatrixXd N(unknowns_, unknowns_);
        Eigen::VectorXd g(unknowns_);
        double sum = normal_equations(x, misfit, N, g), damping = 1e-3;
        for (int step = 0; step < most_steps; ++step) {
            Eigen::MatrixXd damped = N;
            // The second keeps moves of the whole network, which no distance sees, from growing.
            damped.diagonal() *= 1.0 + damping;
            damped.diagonal().array() += 1e-12 * N.diagonal().maxCoeff() + std::numeric_limits<double>::min();
            const Places moved = moved_by(x, damped.ldlt().solve(g));
            const double after = sum_of_squares(moved, misfit);
            if (!(after < sum)) {
                damping *= 8.0;
                if (damping > 1e9) break;
                continue;
            }
            const bool ends = sum - after < 1e-7 * sum;
            x = moved;
            if (ends) return after;
            damping = std::max(1e-9, damping / 5.0);
            sum = normal_equations(x, misfit, N, g);
        }
        return sum;
    }

private:
    Places moved_by(const Places& x, const Eigen::VectorXd& change) const {
        Places moved = x;
        for (Eigen::Index p = 0; p < x.cols(); ++p)
            for (Eigen::Index c = 0; c < 3; ++c)
                if (!is_held(c, p)) moved(c, p) += change[unknown_(c, p)];
        return moved;
    }

    struct MisfitOfDistance {
        Eigen::Vector3d by_b;  ///< its derivatives by b's place; those by a's are the opposite
        double value = 0.0;
    };
    static MisfitOfDistance misfit_of(const TiedDistance& d, const Places& x, Misfit misfit) {
        const Eigen::Vector3d v = x.col(static_cast<Eigen::Index>(d.b)) -
                                  x.col(static_cast<Eigen::Index>(d.a)) + d.rise * Eigen::Vector3d::UnitZ();
        if (misfit == Misfit::of_squares)
            return {v / d.length, (v.squaredNorm() - d.length * d.length) / (2.0 * d.length)};
        return {v.normalized() / d.u, (v.norm() - d.length) / d.u};
    }

    double sum_of_squares(const Places& x, Misfit misfit) const {
        double sum = 0.0;
        for (const TiedDistance& d : given_.distances) sum += std::pow(misfit_of(d, x, misfit).value, 2);
        return sum;
    }

    double normal_equations(const Places& x, Misfit misfit, Eigen::MatrixXd& N, Eigen::VectorXd& g) const {
        N.setZero();
        g.setZero();
        double sum = 0.0;
        for (const TiedDistance& d : given_.distances) {
            const MisfitOfDistance m = misfit_of(d, x, misfit);
            sum += m.value * m.value;
            const std::array ends{std::pair(static_cast<Eigen::Index>(d.a), -1.0),
                                  std::pair(static_cast<Eigen::Index>(d.b), 1.0)};
            for (const auto& [p, sign] : ends)
                for (Eigen::Index c = 0; c < 3; ++c) {
                    if (is_held(c, p)) continue;
                    const double by = sign * m.by_b[c];
                    g[unknown_(c, p)] -= by * m.value;
                    for (const auto& [q, other] : ends)
                        for (Eigen::Index k = 0; k < 3; ++k)
                            if (!is_held(k, q)) N(unknown_(c, p), unknown_(k, q)) += by * other * m.by_b[k];
                }
        }
        return sum;
    }

    const PointsAndDistances& given_;
    Eigen::Matrix<Eigen::Index, 3, Eigen::Dynamic> unknown_;  ///< number of each coordinate; -1: held
    Eigen::Index unknowns_ = 0;
};

PointsByDistances found_at(const Places& x, double sum) {
    PointsByDistances found{{}, sum};
    for (Eigen::Index p = 0; p < x.cols(); ++p) found.places.emplace_back(x.col(p));
    return found;
}

/// Places spread about those that are held, as far as the distances reach.
Places spread(const PointsAndDistances& given, const DistanceSearch& search, std::mt19937_64& engine) {
    double reach = 0.0;
    for (const TiedDistance& d : given.distances)
        reach += d.length / static_cast<double>(given.distances.size());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), count = Eigen::Vector3d::Zero();
    Places x = Places::Zero(3, static_cast<Eigen::Index>(given.places.size()));
    for (Eigen::Index p = 0; p < x.cols(); ++p)
        for (Eigen::Index c = 0; c < 3; ++c) {
            if (!search.is_held(c, p)) continue;
            x(c, p) = given.places[static_cast<std::size_t>(p)][c];
            middle[c] += x(c, p);
            count[c] += 1.0;
        }
    middle = middle.cwiseQuotient(count.cwiseMax(1.0));
    for (Eigen::Index p = 0; p < x.cols(); ++p)
        for (Eigen::Index c = 0; c < 3; ++c) {
            // The engine's own numbers: distributions differ between libraries.
            const double unit = static_cast<double>(engine() >> 11U) * 0x1p-52 - 1.0;
            if (!search.is_held(c, p)) x(c, p) = middle[c] + 0.6 * reach * unit;
        }
    return x;
}

/// Turns points over, each to the other side of what it is tied to, where the sum of squares is less there:
/// most places that are not the least are of points on the wrong side.
double turn_over(const PointsAndDistances& given, const DistanceSearch& search, Places& places,
                 double least) {
    for (std::size_t p = 0; p < given.places.size(); ++p) {
        const auto column = static_cast<Eigen::Index>(p);
        if (search.is_held(0, column) && search.is_held(1, column) && search.is_held(2, column)) continue;
        std::vector<Eigen::Vector3d> others;
        for (const TiedDistance& d : given.distances)
            if (d.a == p || d.b == p)
                others.emplace_back(places.col(static_cast<Eigen::Index>(d.a == p ? d.b : d.a)));
        if (others.size() < 3) continue;
        Places turned = places;
        const Eigen::Vector3d image = plane_of(others).image(places.col(column));
        for (Eigen::Index c = 0; c < 3; ++c)
            if (!search.is_held(c, column)) turned(c, column) = image[c];
        const double sum = search.settle(turned, Misfit::of_lengths);
        if (!(sum < least)) continue;
        least = sum;
        places = turned;
    }
    return least;
}

/// The sum of squares that readings of their u hardly exceed where the places are right.
double largest_likely_sum(const PointsAndDistances& given, const DistanceSearch& search) {
    constexpr double moves_of_a_body = 6.0, often = 5.0;
    const bool floats = std::ranges::none_of(given.holds, [](const auto& h) { return h[0] || h[1] || h[2]; });
    const double redundancy = static_cast<double>(given.distances.size()) -
                              static_cast<double>(search.unknowns()) + (floats ? moves_of_a_body : 0.0);
    const double mean = std::max(0.0, redundancy);
    return mean + often * std::sqrt(2.0 * mean) + often;
}

}  // namespace

PointsByDistances points_from_distances(const PointsAndDistances& given) {
    constexpr int most_beginnings = 200, often_enough = 20;
    constexpr std::uint64_t seed = 20261129;
    constexpr double same = 1e-3;
    const DistanceSearch search(given);
    std::mt19937_64 engine(seed);
    const double agrees = largest_likely_sum(given, search);
    Places best;
    double least = std::numeric_limits<double>::infinity();
    int met = 0;
    for (int k = 0; k < most_beginnings && met < often_enough && !(least < agrees); ++k) {
        Places x = spread(given, search, engine);
        search.settle(x, Misfit::of_squares);
        const double sum = search.settle(x, Misfit::of_lengths);
        if (sum < least * (1.0 + same)) ++met;
        if (!(sum < least * (1.0 - same))) continue;
        met = 1;
        least = sum;
        best = x;
        if (!(least < agrees)) least = turn_over(given, search, best, least);
    }
    return found_at(best, least);
}

PointsByDistances nearest_by_distances(const PointsAndDistances& given) {
    Places x(3, static_cast<Eigen::Index>(given.places.size()));
    for (std::size_t p = 0; p < given.places.size(); ++p)
        x.col(static_cast<Eigen::Index>(p)) = given.places[p];
    const double sum = DistanceSearch(given).settle(x, Misfit::of_lengths);
    return found_at(x, sum);
}

}  // namespace covaria
