#include "core/quantity/copula.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "core/math/decompositions.h"
#include "core/text/numbers.h"

namespace covaria::detail {

namespace {

constexpr std::size_t hermite_terms = 300;
constexpr double grid_step = 0.02;
constexpr double grid_end = 30.0;  // scores of probabilities down to 1e-197: tails of Student t near nu = 2
constexpr auto grid_points = static_cast<std::size_t>(2.0 * grid_end / grid_step) + 1;

double grid_score(std::size_t i) {
    return -grid_end + grid_step * static_cast<double>(i);
}

/// A standardised component as a function of its normal score.
struct ScoreFunction {
    std::vector<double> coefficients;  ///< a_k; a_0 = 0
    std::vector<double> weighted;      ///< on the grid, times the root of the weight; empty: nothing but a_1
};

/// Coefficients by the trapezoidal rule with Hermite functions h_k(z) sqrt(phi(z)), which stay bounded.
ScoreFunction score_function_of(const Distribution& distribution, bool mirrored) {
    std::vector<double> z(grid_points), g(grid_points), root(grid_points);
    for (std::size_t i = 0; i < grid_points; ++i) {
        z[i] = grid_score(i);
        root[i] =
            std::sqrt(grid_step) * std::pow(2.0 * std::numbers::pi, -0.25) * std::exp(-0.25 * z[i] * z[i]);
    }
    distribution.from_standard_normal(z, g);
    if (mirrored) {
        std::reverse(g.begin(), g.end());
        for (double& value : g) value = -value;
    }
    ScoreFunction made{std::vector<double>(hermite_terms + 1, 0.0), std::move(g)};
    double mean = 0.0, square = 0.0;
    for (std::size_t i = 0; i < grid_points; ++i) mean += made.weighted[i] * root[i] * root[i];
    for (std::size_t i = 0; i < grid_points; ++i) {
        made.weighted[i] = (made.weighted[i] - mean) * root[i];
        square += made.weighted[i] * made.weighted[i];
    }
    for (double& value : made.weighted) value /= std::sqrt(square);
    for (std::size_t i = 0; i < grid_points; ++i) {
        double before = 0.0, now = root[i];
        for (std::size_t k = 1; k <= hermite_terms; ++k) {
            const auto n = static_cast<double>(k);
            before = std::exchange(now, (z[i] * now - std::sqrt(n - 1.0) * before) / std::sqrt(n));
            made.coefficients[k] += made.weighted[i] * now;
        }
    }
    return made;
}

using ScoreFunctionPointer = std::shared_ptr<const ScoreFunction>;

/// Functions by shape, kept. The result depends on the key alone, not on who asks first.
class KnownFunctions {
public:
    ScoreFunctionPointer get(const Distribution& distribution) {
        const double u = distribution.standard_deviation();
        const Distribution unit = distribution.shifted(-distribution.mean()).scaled(1.0 / u);
        std::vector<double> shape = distribution_parameters(unit);
        if (!find_distribution_kind(distribution.kind())->parameters.empty())
            for (double& parameter : shape) parameter = static_cast<double>(static_cast<float>(parameter));
        const bool mirrored = unit.factor() < 0.0;
        std::vector<double> key{static_cast<double>(unit.parameters().index()), mirrored ? -1.0 : 1.0};
        key.insert(key.end(), shape.begin(), shape.end());
        const std::lock_guard lock(mutex_);
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        if (known_.size() >= most) known_.clear();
        const Distribution rounded = distribution_from(distribution.kind(), shape).value_or(unit);
        return known_[key] = std::make_shared<ScoreFunction>(score_function_of(rounded, mirrored));
    }

private:
    static constexpr std::size_t most = 200;
    std::mutex mutex_;
    std::map<std::vector<double>, ScoreFunctionPointer> known_;
};

/// A member of an estimate of variance: z/sqrt(chi^2/nu), standardised, given z is z times this on average:
/// E(1/sqrt(chi^2/nu)) over the root of E(nu/chi^2).
ScoreFunctionPointer member_function(double nu) {
    const double part =
        std::sqrt(0.5 * (nu - 2.0)) * std::exp(std::lgamma(0.5 * (nu - 1.0)) - std::lgamma(0.5 * nu));
    return std::make_shared<ScoreFunction>(ScoreFunction{{0.0, part}, {}});
}

/// r(rho) of two components.
class CorrelationOfScores {
public:
    CorrelationOfScores(const ScoreFunction& a, const ScoreFunction& b) {
        const std::size_t terms = std::min(a.coefficients.size(), b.coefficients.size());
        for (std::size_t k = 0; k < terms; ++k) products_.push_back(a.coefficients[k] * b.coefficients[k]);
        double sums[2] = {0.0, 0.0};
        for (std::size_t k = 0; k < terms; ++k) sums[k % 2] += products_[k];
        highest_ = sums[0] + sums[1];
        lowest_ = sums[0] - sums[1];
        if (a.weighted.empty() || b.weighted.empty()) return;
        highest_ = lowest_ = 0.0;
        for (std::size_t i = 0; i < grid_points; ++i) {
            highest_ += a.weighted[i] * b.weighted[i];
            lowest_ += a.weighted[i] * b.weighted[grid_points - 1 - i];
        }
        // The rest of the series goes into two more terms, so that both ends are exact.
        const double rest[2] = {0.5 * (highest_ + lowest_) - sums[0], 0.5 * (highest_ - lowest_) - sums[1]};
        for (std::size_t k = terms; k < terms + 2; ++k) products_.push_back(rest[k % 2]);
        while (products_.size() > 2 && std::abs(products_.back()) < 1e-15) products_.pop_back();
    }
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }
    double at(double rho) const {
        double sum = 0.0;
        for (std::size_t k = products_.size(); k-- > 0;) sum = sum * rho + products_[k];
        return sum;
    }
    /// rho with r(rho) = r; the end of the range that is nearest if there is none.
    double inverse(double r) const {
        double low = -1.0, high = 1.0;
        if (r <= lowest_) return low;
        if (r >= highest_) return high;
        for (int step = 0; step < 54; ++step) {
            const double middle = 0.5 * (low + high);
            (at(middle) < r ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

private:
    std::vector<double> products_;
    double lowest_ = 0.0, highest_ = 0.0;
};

bool combine_arithmetically(const InputSet& inputs, const ComponentCorrelation& pair) {
    const auto has = [](const InputQuantity& quantity, std::size_t component) {
        return std::any_of(quantity.shares.begin(), quantity.shares.end(),
                           [&](const Share& share) { return share.component == component; });
    };
    return std::any_of(inputs.quantities.begin(), inputs.quantities.end(),
                       [&](const InputQuantity& quantity) {
                           return quantity.combination == Combination::arithmetic &&
                                  has(quantity, pair.first) && has(quantity, pair.second);
                       });
}

class CopulaSolver {
public:
    explicit CopulaSolver(const InputSet& inputs)
        : inputs_(inputs),
          estimate_(inputs.estimates_of_components()),
          functions_(inputs.components.size()) {}

    Result<double> coefficient(const ComponentCorrelation& pair) {
        const bool complete = std::abs(pair.coefficient) == 1.0 && combine_arithmetically(inputs_, pair);
        if (pair.coefficient == 0.0 || complete || share_estimate(pair) || keeps(pair.first) ||
            keeps(pair.second) || (is_normal(pair.first) && is_normal(pair.second)))
            return pair.coefficient;
        const CorrelationOfScores r(*function_of(pair.first), *function_of(pair.second));
        constexpr double rounding = 0.005;  // rounding of a coefficient stated with two digits
        if (pair.coefficient < r.lowest() - rounding || pair.coefficient > r.highest() + rounding)
            return impossible(pair, r);
        return r.inverse(pair.coefficient);
    }

private:
    bool share_estimate(const ComponentCorrelation& pair) const {
        return estimate_[pair.first] != InputSet::npos && estimate_[pair.first] == estimate_[pair.second];
    }
    Distribution drawn(std::size_t component) const {
        return drawn_distribution(inputs_.components[component]);
    }
    /// Without a correlation of its own: a constant, or no finite standard deviation.
    bool keeps(std::size_t component) const {
        const double u = drawn(component).standard_deviation();
        return !(u > 0.0) || !std::isfinite(u);
    }
    bool is_normal(std::size_t component) const { return drawn(component).kind() == "normal"; }

    const ScoreFunctionPointer& function_of(std::size_t component) {
        static KnownFunctions known;
        ScoreFunctionPointer& function = functions_[component];
        if (function) return function;
        const Distribution distribution = drawn(component);
        const double nu = distribution.degrees_of_freedom();
        const bool member = estimate_[component] != InputSet::npos && std::isfinite(nu);
        return function = member ? member_function(nu) : known.get(distribution);
    }

    tl::unexpected<Error> impossible(const ComponentCorrelation& pair, const CorrelationOfScores& r) const {
        const auto words = [this](std::size_t component) {
            return '"' + inputs_.components[component].id + "\" (" +
                   Message::declared(drawn(component).title()) + ")";
        };
        return fail(
            ErrorCode::bad_input,
            tell<"the components %1 and %2 cannot have the correlation %3: with these distributions it lies "
                 "between %4 and %5.">(words(pair.first), words(pair.second), format_short(pair.coefficient),
                                       format_short(r.lowest()), format_short(r.highest())));
    }

    const InputSet& inputs_;
    std::vector<std::size_t> estimate_;
    std::vector<ScoreFunctionPointer> functions_;
};

}  // namespace

Result<std::vector<ComponentCorrelation>> copula_coefficients(
    const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations) {
    std::vector<ComponentCorrelation> result = correlations;
    CopulaSolver solver(inputs);
    for (ComponentCorrelation& c : result) {
        const Result<double> rho = solver.coefficient(c);
        if (!rho) return fail(rho.error());
        c.coefficient = *rho;
    }
    return result;
}

Eigen::MatrixXd nearest_correlation(const Eigen::MatrixXd& matrix) {
    constexpr double rounding = 1e-10;
    const auto solver = eigen_decomposition(matrix);
    if (solver.eigenvalues().minCoeff() >= -rounding) return matrix;
    const Eigen::MatrixXd possible = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
                                     solver.eigenvectors().transpose();
    const Eigen::VectorXd scale = possible.diagonal().cwiseSqrt().cwiseInverse();
    return scale.asDiagonal() * possible * scale.asDiagonal();
}

}  // namespace covaria::detail
