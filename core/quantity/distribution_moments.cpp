// Means, standard deviations and densities of distributions.
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "core/math/normal_quantile.h"
#include "core/quantity/distribution.h"

namespace covaria {

namespace {

template <class T>
concept symmetric_between_limits =
    std::is_same_v<T, Rectangular> || std::is_same_v<T, CurvilinearTrapezoid> ||
    std::is_same_v<T, Trapezoidal> || std::is_same_v<T, Triangular> || std::is_same_v<T, Arcsine>;

struct Moments {
    double mean = 0.0;
    double standard_deviation = 0.0;
};

/// Moments by quadrature over scores: the closed forms lose all digits for narrow intervals and far tails.
/// The rest beyond 12 from the most probable score counts for nothing.
Moments moments(const TruncatedNormal& t) {
    if (t.standard_deviation == 0.0 || t.low == t.high) return {std::clamp(t.mean, t.low, t.high), 0.0};
    const double a = (t.low - t.mean) / t.standard_deviation;
    const double b = (t.high - t.mean) / t.standard_deviation;
    const double mode = std::clamp(0.0, a, b);
    const double from = std::max(a, mode - 12.0) - mode;
    const double to = std::min(b, mode + 12.0) - mode;
    constexpr int panels = 48;
    const auto integral = [&](auto f) {
        double sum = 0.0;
        for (int i = 0; i < panels; ++i) {
            const double left = from + (to - from) * i / panels;
            const double right = from + (to - from) * (i + 1) / panels;
            sum += boost::math::quadrature::gauss<double, 15>::integrate(
                [&](double v) { return f(v) * std::exp(-v * (mode + 0.5 * v)); }, left, right);
        }
        return sum;
    };
    const double whole = integral([](double) { return 1.0; });
    const double mean = integral([](double v) { return v; }) / whole;
    const double variance = integral([&](double v) { return (v - mean) * (v - mean); }) / whole;
    return {t.mean + t.standard_deviation * (mode + mean), t.standard_deviation * std::sqrt(variance)};
}

Moments moments(const Discrete& d) {
    Moments m;
    double whole = 0.0;
    for (const double probability : d.probabilities) whole += probability;
    for (std::size_t i = 0; i < d.values.size(); ++i) m.mean += d.probabilities[i] / whole * d.values[i];
    double variance = 0.0;
    for (std::size_t i = 0; i < d.values.size(); ++i)
        variance += d.probabilities[i] / whole * (d.values[i] - m.mean) * (d.values[i] - m.mean);
    m.standard_deviation = std::sqrt(variance);
    return m;
}

// JCGM 101 table 1, last but one column.
double variance_of_shape(const Rectangular& r) {
    return (r.high - r.low) * (r.high - r.low) / 12.0;
}
double variance_of_shape(const CurvilinearTrapezoid& c) {
    return (c.high - c.low) * (c.high - c.low) / 12.0 + c.inexactness * c.inexactness / 9.0;
}
double variance_of_shape(const Trapezoidal& t) {
    return (t.high - t.low) * (t.high - t.low) * (1.0 + t.beta * t.beta) / 24.0;
}
double variance_of_shape(const Triangular& t) {
    return (t.high - t.low) * (t.high - t.low) / 24.0;
}
double variance_of_shape(const Arcsine& a) {
    return (a.high - a.low) * (a.high - a.low) / 8.0;
}

template <symmetric_between_limits T>
Moments moments(const T& p) {
    return {p.low + 0.5 * (p.high - p.low), std::sqrt(variance_of_shape(p))};
}

Moments moments(const Normal& n) {
    return {n.mean, n.standard_deviation};
}

Moments moments(const StudentT& t) {
    const double nu = t.degrees_of_freedom;
    if (t.scale == 0.0 || std::isinf(nu)) return {t.mean, t.scale};
    return {t.mean, nu > 2.0 ? t.scale * std::sqrt(nu / (nu - 2.0)) : infinity};
}

Moments moments(const Exponential& e) {
    return {e.mean, e.mean};
}

Moments moments(const Gamma& g) {
    return {g.shape * g.scale, std::sqrt(g.shape) * g.scale};
}

Moments moments(const Lognormal& l) {
    const double variance = l.log_standard_deviation * l.log_standard_deviation;
    const double mean = std::exp(l.log_mean + 0.5 * variance);
    return {mean, mean * std::sqrt(std::expm1(variance))};
}

Moments moments(const Beta& b) {
    const double sum = b.alpha + b.beta;
    const double width = b.high - b.low;
    return {b.low + width * b.alpha / sum, width / sum * std::sqrt(b.alpha * b.beta / (sum + 1.0))};
}

Moments moments(const Laplace& l) {
    return {l.mean, std::numbers::sqrt2 * l.scale};
}

/// Gamma(1 + 2/k) - Gamma(1 + 1/k)^2 loses its digits for great shapes: as Gamma(1 + 1/k)^2 (e^d - 1).
Moments moments(const Weibull& w) {
    const double first = std::lgamma(1.0 + 1.0 / w.shape);
    const double mean = std::exp(first);
    const double variance = std::expm1(std::lgamma(1.0 + 2.0 / w.shape) - 2.0 * first);
    return {w.location + w.scale * mean, std::abs(w.scale) * mean * std::sqrt(variance)};
}

Moments moments(const Poisson& p) {
    return {p.zero + p.step * p.number, std::abs(p.step) * std::sqrt(p.number)};
}

Moments moments(const Binomial& b) {
    const double mean = b.trials * b.probability;
    return {b.zero + b.step * mean, std::abs(b.step) * std::sqrt(mean * (1.0 - b.probability))};
}

Moments moments(const StatedHistogram& h) {
    Moments m;
    double whole = 0.0, variance = 0.0;
    for (const double probability : h.probabilities) whole += probability;
    const auto middle = [&](std::size_t i) { return h.edges[i] + 0.5 * (h.edges[i + 1] - h.edges[i]); };
    for (std::size_t i = 0; i < h.probabilities.size(); ++i) m.mean += h.probabilities[i] / whole * middle(i);
    for (std::size_t i = 0; i < h.probabilities.size(); ++i) {
        const double off = middle(i) - m.mean, width = h.edges[i + 1] - h.edges[i];
        variance += h.probabilities[i] / whole * (off * off + width * width / 12.0);
    }
    m.standard_deviation = std::sqrt(variance);
    return m;
}

double density_at(const Normal& n, double x) {
    return normal_density((x - n.mean) / n.standard_deviation) / n.standard_deviation;
}

double density_at(const StudentT& t, double x) {
    const double nu = t.degrees_of_freedom;
    if (std::isinf(nu)) return density_at(Normal{t.mean, t.scale}, x);
    const double y = (x - t.mean) / t.scale;
    const double constant = boost::math::tgamma_delta_ratio(0.5 * nu, 0.5) * std::sqrt(std::numbers::pi * nu);
    return std::exp(-0.5 * (nu + 1.0) * std::log1p(y * y / nu)) / (constant * t.scale);
}

double density_at(const Rectangular& r, double x) {
    return x < r.low || x > r.high ? 0.0 : 1.0 / (r.high - r.low);
}

double density_at(const CurvilinearTrapezoid& c, double x) {
    if (c.inexactness == 0.0) return density_at(Rectangular{c.low, c.high}, x);
    const double w = 0.5 * (c.high - c.low);
    const double d = c.inexactness;
    const double from_centre = std::abs(x - (c.low + w));
    if (from_centre >= w + d) return 0.0;
    return std::log((w + d) / std::max(w - d, from_centre)) / (4.0 * d);
}

double density_at(const Trapezoidal& t, double x) {
    const double w = 0.5 * (t.high - t.low);
    const double from_centre = std::abs(x - (t.low + w));
    if (from_centre > w) return 0.0;
    const double top = 1.0 / (w * (1.0 + t.beta));
    return from_centre <= t.beta * w ? top : top * (w - from_centre) / (w * (1.0 - t.beta));
}

double density_at(const Triangular& t, double x) {
    return density_at(Trapezoidal{t.low, t.high, 0.0}, x);
}

double density_at(const Arcsine& a, double x) {
    return x < a.low || x > a.high ? 0.0 : std::numbers::inv_pi / std::sqrt((x - a.low) * (a.high - x));
}

double density_at(const Exponential& e, double x) {
    return x < 0.0 ? 0.0 : std::exp(-x / e.mean) / e.mean;
}

double density_at(const Gamma& g, double x) {
    if (x < 0.0) return 0.0;
    if (x == 0.0) return g.shape > 1.0 ? 0.0 : g.shape < 1.0 ? infinity : 1.0 / g.scale;
    return boost::math::gamma_p_derivative(g.shape, x / g.scale) / g.scale;
}

double density_at(const TruncatedNormal& t, double x) {
    if (x < t.low || x > t.high) return 0.0;
    const double a = (t.low - t.mean) / t.standard_deviation;
    const double b = (t.high - t.mean) / t.standard_deviation;
    const bool mirrored = a + b > 0.0;  // differences of small probabilities keep their digits
    const double between =
        normal_distribution_function(mirrored ? -a : b) - normal_distribution_function(mirrored ? -b : a);
    return density_at(Normal{t.mean, t.standard_deviation}, x) / between;
}

double density_at(const Lognormal& l, double x) {
    if (x <= 0.0) return 0.0;
    return density_at(Normal{l.log_mean, l.log_standard_deviation}, std::log(x)) / x;
}

double density_at(const Beta& b, double x) {
    const double width = b.high - b.low;
    const double y = (x - b.low) / width;
    if (y < 0.0 || y > 1.0) return 0.0;
    const double end_exponent = y == 0.0 ? b.alpha : b.beta;
    if ((y == 0.0 || y == 1.0) && end_exponent != 1.0) return end_exponent < 1.0 ? infinity : 0.0;
    if (y == 0.0 || y == 1.0) return std::max(b.alpha, b.beta) / width;
    return boost::math::ibeta_derivative(b.alpha, b.beta, y) / width;
}

double density_at(const Laplace& l, double x) {
    return std::exp(-std::abs(x - l.mean) / l.scale) / (2.0 * l.scale);
}

double density_at(const Weibull& w, double x) {
    const double y = (x - w.location) / w.scale;
    if (y < 0.0) return 0.0;
    if (y == 0.0 && w.shape != 1.0) return w.shape < 1.0 ? infinity : 0.0;
    return w.shape * std::pow(y, w.shape - 1.0) * std::exp(-std::pow(y, w.shape)) / std::abs(w.scale);
}

double density_at(const StatedHistogram& h, double x) {
    if (x < h.edges.front() || x > h.edges.back()) return 0.0;
    const auto above = std::upper_bound(h.edges.begin() + 1, h.edges.end() - 1, x);
    const auto cell = static_cast<std::size_t>(above - h.edges.begin()) - 1;
    double whole = 0.0;
    for (const double probability : h.probabilities) whole += probability;
    return h.probabilities[cell] / whole / (h.edges[cell + 1] - h.edges[cell]);
}

// Distributions with jumps have no density.
double density_at(const Discrete&, double) {
    return 0.0;
}
double density_at(const Poisson&, double) {
    return 0.0;
}
double density_at(const Binomial&, double) {
    return 0.0;
}

Moments moments_of(const DistributionParameters& parameters) {
    return std::visit([](const auto& p) { return moments(p); }, parameters);
}

}  // namespace

double Distribution::mean() const {
    return location_ + factor_ * moments_of(parameters_).mean;
}

double Distribution::standard_deviation() const {
    return std::abs(factor_) * moments_of(parameters_).standard_deviation;
}

double Distribution::standard_uncertainty() const {
    const auto* t = std::get_if<StudentT>(&parameters_);
    return t != nullptr ? t->scale : standard_deviation();
}

double Distribution::degrees_of_freedom() const {
    const auto* t = std::get_if<StudentT>(&parameters_);
    return t != nullptr ? t->degrees_of_freedom : infinity;
}

bool Distribution::has_jumps() const {
    return std::holds_alternative<Discrete>(parameters_) || std::holds_alternative<Poisson>(parameters_) ||
           std::holds_alternative<Binomial>(parameters_);
}

double Distribution::density(double x) const {
    if (has_jumps()) return 0.0;
    const double y = (x - location_) / factor_;
    const Moments m = moments_of(parameters_);
    if (m.standard_deviation == 0.0) return y == m.mean ? infinity : 0.0;
    return std::visit([y](const auto& p) { return density_at(p, y); }, parameters_) / std::abs(factor_);
}

}  // namespace covaria
