// Inversion of characteristic functions.
#include "core/propagation/linear_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math/normal_quantile.h"
#include "core/math/special_quantiles.h"

namespace covaria::detail {
namespace {

constexpr std::size_t usual_points = 8192;
constexpr double period = 64.0;         // in widths
constexpr double heavy_period = 512.0;  // with tails of fewer than six degrees of freedom, or lognormal ones
constexpr double negligible = 1e-14;

double width_of(const LinearTerm& term) {
    const double u = term.distribution.standard_deviation();
    return std::abs(term.factor) * (std::isfinite(u) ? u : term.distribution.standard_uncertainty());
}

bool is_heavy(const LinearTerm& term) {
    return term.distribution.degrees_of_freedom() < 6.0 || term.distribution.kind() == "lognormal" ||
           term.distribution.kind() == "weibull";
}

/// Of a Poisson or binomial distribution; 0 of others.
double step_of(const Distribution& distribution) {
    if (const auto* p = std::get_if<Poisson>(&distribution.parameters())) return p->step;
    if (const auto* b = std::get_if<Binomial>(&distribution.parameters())) return b->step;
    return 0.0;
}

/// Probability that the term exceeds x.
double probability_above(const LinearTerm& t, double x) {
    const double scale = std::abs(t.factor) * t.distribution.standard_uncertainty();
    return t_distribution_function(-x / scale, t.distribution.degrees_of_freedom());
}

}  // namespace

LinearDistribution::LinearDistribution(std::vector<LinearTerm> terms) {
    std::erase_if(terms, [](const LinearTerm& term) { return width_of(term) == 0.0; });
    double variance = 0.0, squares = 0.0;
    for (const LinearTerm& term : terms) {
        const double u = term.factor * term.distribution.standard_deviation();
        variance += u * u;
        squares += width_of(term) * width_of(term);
        has_mean_ = has_mean_ && term.distribution.degrees_of_freedom() > 1.0;
    }
    standard_deviation_ = std::sqrt(variance);
    scale_ = std::sqrt(squares);
    take_closed_forms(terms);
    if (terms.empty()) return;
    choose_grid(terms);
    multiply(terms);
}

/// Leaves the terms whose characteristic functions have to be multiplied.
void LinearDistribution::take_closed_forms(std::vector<LinearTerm>& terms) {
    double variance = 0.0;
    std::erase_if(terms, [&](const LinearTerm& term) {
        const bool normal = term.distribution.kind() == "normal";
        if (normal) variance += width_of(term) * width_of(term);
        return normal;
    });
    normal_ = std::sqrt(variance);
    if (terms.size() == 1 && normal_ == 0.0) alone_ = terms;
}

void LinearDistribution::choose_grid(const std::vector<LinearTerm>& terms) {
    for (const LinearTerm& term : terms)
        if (std::isfinite(term.distribution.degrees_of_freedom())) heavy_.push_back(term);
    const bool far = std::any_of(terms.begin(), terms.end(), is_heavy);
    spacing_ = 2.0 * std::numbers::pi / ((far ? heavy_period : period) * scale_);
    most_points_ = far ? 4 * usual_points : usual_points;
}

/// Equal steps have a characteristic function that comes back to one, perhaps beyond the grid.
bool LinearDistribution::keeps_steps(const std::vector<LinearTerm>& terms) const {
    return std::any_of(terms.begin(), terms.end(), [&](const LinearTerm& stepped) {
        const double step = step_of(stepped.distribution) * stepped.factor;
        if (step == 0.0) return false;
        const double t = 2.0 * std::numbers::pi / std::abs(step);
        std::complex<double> product = std::exp(-0.5 * normal_ * normal_ * t * t);
        for (const LinearTerm& term : terms) product *= (*term.characteristic)(term.factor * t);
        return std::abs(product) > 1e-11;
    });
}

void LinearDistribution::multiply(const std::vector<LinearTerm>& terms) {
    std::size_t small = 0;
    while (values_.size() < most_points_ && small < 64) {
        const double t = (static_cast<double>(values_.size()) + 0.5) * spacing_;
        std::complex<double> product = std::exp(-0.5 * normal_ * normal_ * t * t);
        for (const LinearTerm& term : terms) {
            if (std::abs(product) < negligible) break;
            product *= (*term.characteristic)(term.factor * t);
        }
        small = std::abs(product) < negligible ? small + 1 : 0;
        values_.push_back(product);
    }
    has_density_ = !keeps_steps(terms);
    if (values_.size() < most_points_) return;
    double left = 0.0;
    for (std::size_t k = values_.size() - values_.size() / 8; k < values_.size(); ++k)
        left = std::max(left, std::abs(values_[k]));
    has_density_ = has_density_ && left < 0.05;
    if (left < 1e-11) return;
    damping_ = 6.0 / (static_cast<double>(values_.size()) * spacing_);
    for (std::size_t k = 0; k < values_.size(); ++k) {
        const double t = (static_cast<double>(k) + 0.5) * spacing_;
        values_[k] *= std::exp(-0.5 * damping_ * damping_ * t * t);
    }
}

/// The sum over the grid takes the sign of x - X for a square wave: wrong for X beyond x -+ one period, right
/// again beyond two, and so on. Far out, a sum exceeds a limit when its greatest term does.
double LinearDistribution::wrapped(double x) const {
    const double turn = 2.0 * std::numbers::pi / spacing_;
    constexpr int most = 20;
    double sum = 0.0;
    for (const LinearTerm& term : heavy_)
        for (int m = 1; m <= most; ++m) {
            const double part = probability_above(term, m * turn + x) - probability_above(term, m * turn - x);
            sum += (m % 2 == 1 ? 1.0 : -1.0) * (m == most ? 0.5 : 1.0) * part;  // an alternating series
        }
    return sum;
}

LinearDistribution::Value LinearDistribution::at(double x) const {
    if (values_.empty())
        return {normal_distribution_function(x / normal_), normal_density(x / normal_) / normal_};
    const std::complex<double> turn = std::polar(1.0, -spacing_ * x);
    std::complex<double> place = std::polar(1.0, -0.5 * spacing_ * x);
    double below = 0.0, density = 0.0, slope = 0.0;
    for (std::size_t k = 0; k < values_.size(); ++k) {
        const double re = place.real() * values_[k].real() - place.imag() * values_[k].imag();
        const double im = place.real() * values_[k].imag() + place.imag() * values_[k].real();
        const double t = static_cast<double>(k) + 0.5;
        below += im / t;
        density += re;
        slope += t * im;
        place = {place.real() * turn.real() - place.imag() * turn.imag(),
                 place.real() * turn.imag() + place.imag() * turn.real()};
    }
    const double factor = spacing_ / std::numbers::pi;
    const double correction = 0.5 * damping_ * damping_ * slope * spacing_ * factor;
    return {0.5 - below / std::numbers::pi - wrapped(x) - correction, density * factor};
}

double LinearDistribution::distribution_function(double x) const {
    if (scale_ == 0.0) return x < 0.0 ? 0.0 : 1.0;
    return at(x).probability;
}

std::optional<double> LinearDistribution::quantile(double p) const {
    if (!alone_.empty() && !alone_.front().distribution.has_jumps()) {
        const LinearTerm& term = alone_.front();
        const double x = term.distribution.quantile(term.factor > 0.0 ? p : 1.0 - p);
        return term.factor * (x - term.distribution.mean());
    }
    if (!has_density_) return {};
    double x = normal_quantile(p) * scale_;
    if (values_.empty()) return x;
    const double half = std::numbers::pi / spacing_;
    double low = -half, high = half;
    for (int step = 0; step < 100; ++step) {
        const Value value = at(x);
        (value.probability < p ? low : high) = x;
        const double newton = x - (value.probability - p) / value.density;
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (std::abs(next - x) <= 1e-13 * scale_) break;
        x = next;
    }
    return std::abs(x) < 0.5 * half ? std::optional(x) : std::nullopt;
}

}  // namespace covaria::detail
