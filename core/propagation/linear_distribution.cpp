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
constexpr double period = 64.0;         // period of the grid in widths
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

/// Step of a Poisson or binomial distribution; 0 of others.
double step_of(const Distribution& distribution) {
    if (const auto* p = std::get_if<Poisson>(&distribution.parameters())) return p->step;
    if (const auto* b = std::get_if<Binomial>(&distribution.parameters())) return b->step;
    return 0.0;
}

/// Probability that the term lies further than `distance` > 0 from its mean, to the next greater power of
/// ten; of a Student t what is left of it once `wrapped` has taken out the term by itself.
double probability_beyond(const LinearTerm& t, double distance) {
    const double nu = t.distribution.degrees_of_freedom();
    const double reach = distance / std::abs(t.factor), mean = t.distribution.mean();
    constexpr double by_itself = 1e-3;
    if (std::isfinite(nu))
        return by_itself * 2.0 * t_distribution_function(-reach / t.distribution.standard_uncertainty(), nu);
    double sum = 0.0;
    for (const bool above : {false, true})
        for (double p = 1e-15; p < 1.0; p *= 10.0) {
            const double x = t.distribution.quantile(above ? 1.0 - p : p);
            const bool inside = above ? x - mean <= reach : mean - x <= reach;
            if (!inside) continue;
            sum += p > 1e-15 ? p : 0.0;
            break;
        }
    return sum;
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
    lasting_error_ += beyond_grid(terms);
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
        double size = product.real(), at_most = size;  // at_most: with the errors of the factors
        for (const LinearTerm& term : terms) {
            if (at_most < negligible) break;
            const std::complex<double> factor = (*term.characteristic)(term.factor * t);
            product *= factor;
            size *= std::abs(factor);
            at_most *= std::abs(factor) + term.characteristic->error(term.factor * t);
        }
        lasting_error_ += (at_most - size) / ((static_cast<double>(values_.size()) + 0.5) * std::numbers::pi);
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

/// A sum comes from beyond half a period when its greatest term does: the others reach some widths at most.
double LinearDistribution::beyond_grid(const std::vector<LinearTerm>& terms) const {
    const double turn = 2.0 * std::numbers::pi / spacing_;
    constexpr double by_others = 12.0;
    double sum = 0.0;
    for (const LinearTerm& term : terms) sum += probability_beyond(term, 0.75 * turn - by_others * scale_);
    return sum;
}

LinearDistribution::Value LinearDistribution::damped_at(double x, double further) const {
    if (values_.empty())
        return {normal_distribution_function(x / normal_), normal_density(x / normal_) / normal_};
    const std::complex<double> turn = std::polar(1.0, -spacing_ * x);
    std::complex<double> place = std::polar(1.0, -0.5 * spacing_ * x);
    double below = 0.0, density = 0.0, slope = 0.0;
    for (std::size_t k = 0; k < values_.size(); ++k) {
        const double t = static_cast<double>(k) + 0.5;
        const double left = further > 0.0 ? std::exp(-0.5 * further * t * t * spacing_ * spacing_) : 1.0;
        const double re = left * (place.real() * values_[k].real() - place.imag() * values_[k].imag());
        const double im = left * (place.real() * values_[k].imag() + place.imag() * values_[k].real());
        below += im / t;
        density += re;
        slope += t * im;
        place = {place.real() * turn.real() - place.imag() * turn.imag(),
                 place.real() * turn.imag() + place.imag() * turn.real()};
    }
    const double factor = spacing_ / std::numbers::pi;
    const double correction = 0.5 * (damping_ * damping_ + further) * slope * spacing_ * factor;
    return {0.5 - below / std::numbers::pi - wrapped(x) - correction, density * factor};
}

double LinearDistribution::distribution_function(double x) const {
    if (scale_ == 0.0) return x < 0.0 ? 0.0 : 1.0;
    return at(x).probability;
}

/// Twice as wide a damping does at least a third more harm, also where the density is as peaked as that of an
/// arcsine distribution at its ends.
double LinearDistribution::error(double x) const {
    if (is_closed()) return 0.0;
    constexpr double rounding = 1e-13, as_much_again = 4.0;
    double worst = 0.0;
    for (double place = x - 2.0 * damping_; damping_ > 0.0 && place < x + 2.5 * damping_; place += damping_)
        worst = std::max(
            worst, std::abs(at(place).probability - damped_at(place, 3.0 * damping_ * damping_).probability));
    return lasting_error_ + rounding + as_much_again * worst;
}

std::optional<KnownQuantile> LinearDistribution::known_quantile(double p) const {
    const auto value = quantile(p);
    if (!value) return {};
    const double off = error(*value);
    if (off == 0.0) return KnownQuantile{*value, 0.0};
    if (!(off < p && off < 1.0 - p)) return KnownQuantile{*value, infinity};
    const auto low = quantile(p - off), high = quantile(p + off);
    if (!low || !high) return KnownQuantile{*value, infinity};
    return KnownQuantile{*value, std::max(*high - *value, *value - *low)};
}

std::optional<double> LinearDistribution::quantile(double p) const {
    if (!alone_.empty()) {
        const LinearTerm& term = alone_.front();
        if (term.distribution.has_jumps()) return {};
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
