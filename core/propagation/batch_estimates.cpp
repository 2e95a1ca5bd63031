// Regression of batches on their controls.
#include "core/propagation/batch_estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"

namespace covaria::detail {
namespace {

constexpr double greatest_gain = 1e12;             // reached by linear models, where only rounding is left
constexpr double beyond_two = 0.0227501319481792;  // part of a normal distribution beyond two u

/// A scatter known from few degrees of freedom.
double widening(double degrees_of_freedom) {
    return 0.5 * t_quantile(1.0 - beyond_two, degrees_of_freedom);
}

Eigen::Index terms_of(std::size_t figure) {
    return figure < 2 ? 2 : 3;
}

}  // namespace

BatchEstimates::BatchEstimates(std::size_t outputs, const std::vector<Control>& controls)
    : control_of_(outputs, none), sums_(outputs) {
    for (std::size_t k = 0; k < controls.size(); ++k) {
        control_of_[controls[k].output] = k;
        for (std::size_t f = 0; f < BatchFigures::count; ++f) {
            sums_[controls[k].output][f].expectation = controls[k].expectation[f];
            sums_[controls[k].output][f].error = controls[k].error[f];
        }
    }
}

void BatchEstimates::add(const std::vector<BatchFigures>& figures) {
    const auto h = static_cast<double>(++batches_);
    for (std::size_t j = 0; j < sums_.size(); ++j)
        for (std::size_t f = 0; f < BatchFigures::count; ++f) {
            Sums& s = sums_[j][f];
            const double y = figures[j].values[f];
            const double from_y = y - s.y;
            s.y += from_y / h;
            s.yy += from_y * (y - s.y);
            if (control_of_[j] == none) continue;
            const double l = figures[sums_.size() + control_of_[j]].values[f];
            if (batches_ == 1) s.first_d = y - l;
            const double v = l - s.expectation, d = y - l - s.first_d;
            double power = 1.0;
            for (std::size_t k = 0; k < s.v.size(); ++k, power *= v) {
                s.v[k] += power;
                if (k < s.dv.size()) s.dv[k] += d * power;
            }
            s.dd += d * d;
        }
}

void BatchEstimates::forget_controls() {
    std::fill(control_of_.begin(), control_of_.end(), none);
}

/// Least squares of d on powers of v.
struct BatchEstimates::Fit {
    Eigen::VectorXd coefficients;  ///< coefficients of powers of v / width
    double width = 1.0;
    double residual = 0.0;          ///< variance about it
    double variance_at_zero = 0.0;  ///< variance of the value at v = 0, for a residual variance of one
};

BatchEstimates::Fit BatchEstimates::fitted(const Sums& s, Eigen::Index terms) {
    const double h = s.v[0], width = std::sqrt(s.v[2] / h);
    Eigen::MatrixXd normal(terms, terms);
    Eigen::VectorXd right(terms);
    for (Eigen::Index a = 0; a < terms; ++a) {
        right(a) = s.dv[static_cast<std::size_t>(a)] / std::pow(width, a);
        for (Eigen::Index b = 0; b < terms; ++b)
            normal(a, b) = s.v[static_cast<std::size_t>(a + b)] / std::pow(width, a + b);
    }
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    const Eigen::VectorXd coefficients = solver.solve(right);
    const Eigen::VectorXd at_zero = solver.solve(Eigen::VectorXd::Unit(terms, 0));
    const double residual = std::max(0.0, s.dd - coefficients.dot(right)) / (h - static_cast<double>(terms));
    return {coefficients, width, residual, at_zero(0)};
}

/// Least squares of d on 1, v and for the ends v^2, read at v = 0.
BatchEstimates::Estimate BatchEstimates::controlled(const Sums& s, std::size_t figure) const {
    const Eigen::Index terms = terms_of(figure);
    const Fit fit = fitted(s, terms);
    Estimate estimate;
    estimate.value = s.expectation + s.first_d + fit.coefficients(0);
    estimate.slope = 1.0 + fit.coefficients(1) / fit.width;
    estimate.controlled = true;
    double square = fit.residual * fit.variance_at_zero;
    if (terms > 2) {
        const Fit cubic = fitted(s, terms + 1);
        const double change = cubic.coefficients(0) - fit.coefficients(0);
        const double by_noise = cubic.residual * (cubic.variance_at_zero - fit.variance_at_zero);
        square += std::max(0.0, change * change - std::max(0.0, by_noise));
    }
    estimate.standard_error = std::sqrt(square) + std::abs(estimate.slope) * s.error;
    return estimate;
}

BatchEstimates::Estimate BatchEstimates::estimate(std::size_t output, std::size_t figure) const {
    const Sums& s = sums_[output][figure];
    const auto h = static_cast<double>(batches_);
    if (batches_ < least_batches) return {s.y, std::numeric_limits<double>::quiet_NaN(), 1.0, false, 0.0};
    const double scatter = std::sqrt(s.yy / (h * (h - 1.0)));
    const Estimate plain{s.y, scatter * widening(h - 1.0), 1.0, false, 0.0};
    if (control_of_[output] == none || !std::isfinite(s.expectation) || !(s.v[2] > 0.0)) return plain;
    Estimate estimate = controlled(s, figure);
    if (!(estimate.standard_error < scatter)) return plain;
    estimate.gain = std::min(greatest_gain, std::pow(scatter / estimate.standard_error, 2));
    estimate.standard_error *= widening(h - static_cast<double>(terms_of(figure)));
    return estimate;
}

}  // namespace covaria::detail
