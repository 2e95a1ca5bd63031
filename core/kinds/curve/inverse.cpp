// Places at which a calibration curve takes a value: inverse use.
#include <algorithm>
#include <cmath>

#include "core/kinds/curve/fit.h"

namespace covaria::curve {

namespace {

/// Coefficients by rising powers.
using Powers = std::vector<double>;

double value_at(const Powers& p, double t) {
    double sum = 0.0;
    for (std::size_t k = p.size(); k-- > 0;) sum = sum * t + p[k];
    return sum;
}

Powers derivative_of(const Powers& p) {
    Powers slope;
    for (std::size_t k = 1; k < p.size(); ++k) slope.push_back(double(k) * p[k]);
    return slope;
}

double bisected(const Powers& p, double low, double high) {
    const bool rising = value_at(p, low) < 0.0;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        ((value_at(p, middle) < 0.0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Real roots between -bound and bound: between the extremes, which are the roots of the derivative.
std::vector<double> roots_of(const Powers& p, double bound) {
    if (p.size() < 2) return {};
    std::vector<double> places{-bound};
    for (const double extreme : roots_of(derivative_of(p), bound)) places.push_back(extreme);
    places.push_back(bound);
    std::vector<double> roots;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double low = value_at(p, places[i]), high = value_at(p, places[i + 1]);
        if ((low < 0.0) != (high < 0.0)) roots.push_back(bisected(p, places[i], places[i + 1]));
    }
    return roots;
}

/// The curve in powers of t.
Powers powers_of_t(const Fit& fit) {
    const Polynomials& p = fit.polynomials;
    const std::size_t size = p.count + (p.zero ? 1 : 0);
    std::vector<Powers> rows{Powers(size, 0.0)};
    rows[0][p.zero ? 1 : 0] = p.first;
    if (p.zero) rows[0][0] = -p.first * *p.zero;
    for (std::size_t k = 0; k + 1 < p.count; ++k) {
        Powers next(size, 0.0);
        for (std::size_t m = 0; m < size; ++m) {
            next[m] = m > 0 ? rows[k][m - 1] : 0.0;
            for (std::size_t j = 0; j <= k; ++j) next[m] -= p.recurrence[k][j] * rows[j][m];
            next[m] *= p.factor[k];
        }
        rows.push_back(std::move(next));
    }
    Powers sum(size, 0.0);
    for (std::size_t j = 0; j < p.count; ++j)
        for (std::size_t m = 0; m < size; ++m) sum[m] += fit.q[j] * rows[j][m];
    return sum;
}

constexpr double between_the_points = 1.0 + 1e-9;

std::string listed(const CurveSetup& setup, const Fit& fit, const std::vector<double>& places) {
    std::string text;
    for (const double t : places)
        text += (text.empty() ? "" : ", ") + place_text(setup.x_unit, fit.polynomials.x_of(t));
    return text;
}

Result<double> chosen(const CurveSetup& setup, const Fit& fit, const Observation& observation,
                      const std::vector<double>& places) {
    const std::string y = "y = " + place_text(setup.y_unit, observation.y);
    if (places.empty()) return fail(ErrorCode::bad_input, tell<"the curve does not reach %1">(y));
    if (observation.near) {
        const double near = fit.polynomials.t_of(*observation.near);
        return *std::min_element(places.begin(), places.end(),
                                 [&](double a, double b) { return std::abs(a - near) < std::abs(b - near); });
    }
    std::vector<double> inside;
    for (const double t : places)
        if (std::abs(t) <= between_the_points) inside.push_back(t);
    const std::vector<double>& candidates = inside.empty() ? places : inside;
    if (candidates.size() == 1) return candidates.front();
    return fail(ErrorCode::bad_input,
                tell<"the curve reaches %1 at x = %2%3: say in 'near' which of them is meant">(
                    y, listed(setup, fit, candidates),
                    (inside.empty() ? tell<", outside of its points">() : Message())));
}

}  // namespace

std::vector<double> places_where(const Fit& fit, double y) {
    Powers p = powers_of_t(fit);
    p[0] -= y;
    while (p.size() > 1 && p.back() == 0.0) p.pop_back();
    double bound = 0.0;  // Cauchy's, of all roots; extrapolation by a thousand widths says nothing anyway
    for (std::size_t k = 0; k + 1 < p.size(); ++k) bound = std::max(bound, std::abs(p[k] / p.back()));
    return roots_of(p, std::min(1.0 + bound, 1000.0));
}

Result<InversePlace> inverse_place(const CurveSetup& setup, const Fit& fit, const Observation& observation) {
    const std::vector<double> places = places_where(fit, observation.y);
    const auto t = chosen(setup, fit, observation, places);
    if (!t) return fail(t.error());
    InversePlace made;
    made.t = *t;
    Values<double> phi, slopes, q{};
    std::copy(fit.q.begin(), fit.q.end(), q.begin());
    fit.polynomials.at(made.t, phi, slopes);
    made.slope = sum_of(q, slopes, fit.polynomials.count);
    for (const double other : places)
        if (other != *t) made.others.push_back(fit.polynomials.x_of(other));
    made.outside = std::abs(made.t) > between_the_points;
    return made;
}

}  // namespace covaria::curve
