// Characteristic functions, kind by kind.
#include "core/quantity/characteristic_function.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

#include "core/math/normal_quantile.h"

namespace covaria {
namespace {

using Complex = std::complex<double>;
using Function = std::function<Complex(double)>;

double sine_over(double x) {
    return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

/// Sine integral: power series up to 4, beyond it pi/2 + Im E1(ix) by the continued fraction (Abramowitz and
/// Stegun 5.2.14, 5.1.22).
double sine_integral(double x) {
    if (x < 0.0) return -sine_integral(-x);
    if (x <= 4.0) {
        double power = x, sum = x;
        for (int k = 1; k < 30; ++k) {
            power *= -x * x / ((2.0 * k) * (2.0 * k + 1.0));
            sum += power / (2.0 * k + 1.0);
        }
        return sum;
    }
    Complex b(1.0, x), c(1e300, 0.0), d = 1.0 / b, h = d;
    for (int k = 1; k < 200; ++k) {
        const double a = -static_cast<double>(k) * k;
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        const Complex step = c * d;
        h *= step;
        if (std::abs(step.real() - 1.0) + std::abs(step.imag()) < 1e-16) break;
    }
    h *= std::polar(1.0, -x);
    return 0.5 * std::numbers::pi + h.imag();
}

/// ln E exp(-tau^2/(2 c)) with c = chi^2/nu: the characteristic function of Student's t as a mixture of
/// normal ones. In ln c the integrand ends faster than exponentially, so the trapezoidal rule is as good as
/// exact.
double log_of_student_t(double nu, double tau) {
    const double half = 0.5 * nu, energy = 0.5 * tau * tau;
    const auto exponent = [&](double y) { return half * (y - std::exp(y)) - energy * std::exp(-y); };
    // exp(y) at the greatest value: half e^2 - half e - energy = 0
    const double peak = std::log(0.5 + 0.5 * std::sqrt(1.0 + 4.0 * energy / half));
    const double curvature = half * std::exp(peak) + energy * std::exp(-peak);
    const double step = std::min(0.2, 0.4 / std::sqrt(curvature));
    const double most = exponent(peak);
    double sum = 1.0;
    for (const double direction : {-step, step})
        for (double y = peak + direction;; y += direction) {
            const double part = std::exp(exponent(y) - most);
            sum += part;
            if (part < 1e-17) break;
        }
    return most + std::log(sum * step) + half * std::log(half) - std::lgamma(half);
}

/// Table of that logarithm over ln tau in equal steps, read by six points (Lagrange).
class StudentTTable {
public:
    explicit StudentTTable(double nu) : nu_(nu) {
        for (double place = first; place < last; place += step)
            values_.push_back(log_of_student_t(nu, std::exp(place)));
    }
    double operator()(double tau) const {
        if (!(tau > 0.0)) return 1.0;
        const double place = (std::log(tau) - first) / step;
        if (place < 2.0) return std::exp(log_of_student_t(nu_, tau));
        if (place > static_cast<double>(values_.size()) - 4.0) return 0.0;
        const auto at = static_cast<std::size_t>(place);
        return std::exp(interpolated(values_.data() + at - 2, place - static_cast<double>(at)));
    }

private:
    static constexpr double first = -7.0, last = 6.5, step = 0.02;

    /// `v` are the values at -2 ... 3.
    static double interpolated(const double* v, double s) {
        const double a = s + 2, b = s + 1, c = s - 1, d = s - 2, e = s - 3;
        return -v[0] * b * s * c * d * e / 120 + v[1] * a * s * c * d * e / 24 -
               v[2] * a * b * c * d * e / 12 + v[3] * a * b * s * d * e / 12 - v[4] * a * b * s * c * e / 24 +
               v[5] * a * b * s * c * d / 120;
    }

    double nu_;
    std::vector<double> values_;
};

/// Tables by degrees of freedom: made once, used by all components with as many.
std::shared_ptr<const StudentTTable> student_t_table(double nu) {
    static std::mutex mutex;
    static std::map<double, std::shared_ptr<const StudentTTable>> tables;
    constexpr std::size_t most = 200;
    const std::lock_guard lock(mutex);
    if (const auto known = tables.find(nu); known != tables.end()) return known->second;
    if (tables.size() >= most) tables.clear();
    return tables[nu] = std::make_shared<const StudentTTable>(nu);
}

Function normal_function(double sigma) {
    return [sigma](double t) { return Complex(std::exp(-0.5 * sigma * sigma * t * t)); };
}

Function rectangular_function(double half) {
    return [half](double t) { return Complex(sine_over(half * t)); };
}

constexpr double error_of_table = 1e-9;

/// Sums over nodes x_k with weights w_k, of zero mean.
struct Nodes {
    std::vector<double> x, weight;
    Complex operator()(double t) const {
        double real = 0.0, imaginary = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            real += weight[k] * std::cos(t * x[k]);
            imaginary += weight[k] * std::sin(t * x[k]);
        }
        return {real, imaginary};
    }
};

/// Gauss' rule of five points integrates exp(i theta s) over -1 ... 1 to 8.1e-10 theta^10 (its error term for
/// the tenth derivative), and beyond its reach to no more than twice the weight of the panel.
struct QuadratureError {
    std::vector<double> half_turns, weight;  ///< of each panel: half the change of x; probability
    double operator()(double t) const {
        double sum = error_of_table;
        for (std::size_t k = 0; k < weight.size(); ++k) {
            const double theta = t * half_turns[k], square = theta * theta;
            sum += weight[k] * std::min(2.0, 8.1e-10 * square * square * square * square * square);
        }
        return sum;
    }
};

constexpr double last_score = 8.2;
constexpr int panels = 400;

/// Error of `by_quadrature` for the distribution.
QuadratureError quadrature_error(const Distribution& distribution) {
    std::vector<double> scores, edges(panels + 1);
    for (int edge = 0; edge <= panels; ++edge) scores.push_back(last_score * (2.0 * edge / panels - 1.0));
    distribution.from_standard_normal(scores, edges);
    QuadratureError error;
    for (std::size_t k = 0; k < panels; ++k) {
        error.half_turns.push_back(0.5 * (edges[k + 1] - edges[k]));
        error.weight.push_back(normal_distribution_function(scores[k + 1]) -
                               normal_distribution_function(scores[k]));
    }
    return error;
}

/// Quantiles over scores, which make all of these distributions smooth.
Function by_quadrature(const DistributionParameters& parameters) {
    const Distribution distribution = Distribution::of(parameters);
    const double mean = distribution.mean();
    constexpr double end = last_score;
    using Gauss = boost::math::quadrature::gauss<double, 5>;
    Nodes nodes;
    std::vector<double> scores;
    for (int panel = 0; panel < panels; ++panel) {
        const double width = end / panels, centre = -end + (2 * panel + 1) * width;
        for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k)
            for (const double side : {-1.0, 1.0}) {
                if (k == 0 && side < 0.0) continue;  // the middle one
                scores.push_back(centre + side * width * Gauss::abscissa()[k]);
                nodes.weight.push_back(width * Gauss::weights()[k] * normal_density(scores.back()));
            }
    }
    nodes.x.resize(scores.size());
    distribution.from_standard_normal(scores, nodes.x);
    for (double& x : nodes.x) x -= mean;
    return nodes;
}

Function function_of(const Normal& n) {
    return normal_function(n.standard_deviation);
}

Function function_of(const StudentT& t) {
    if (std::isinf(t.degrees_of_freedom) || t.scale == 0.0) return normal_function(t.scale);
    return [table = student_t_table(t.degrees_of_freedom), scale = t.scale](double x) {
        return Complex((*table)(scale * std::abs(x)));
    };
}

Function function_of(const Rectangular& r) {
    return rectangular_function(0.5 * (r.high - r.low));
}

/// A half-width z rectangular in w -+ d, times a rectangular number: the mean of sin(zt)/(zt) over z.
Function function_of(const CurvilinearTrapezoid& c) {
    const double w = 0.5 * (c.high - c.low), d = c.inexactness;
    if (d == 0.0) return rectangular_function(w);
    return [w, d](double t) {
        if (std::abs(d * t) > 2.0)
            return Complex((sine_integral((w + d) * t) - sine_integral((w - d) * t)) / (2.0 * d * t));
        const auto part = [&](double v) { return 0.5 * sine_over((w + d * v) * t); };
        return Complex(boost::math::quadrature::gauss<double, 15>::integrate(part, -1.0, 1.0));
    };
}

/// The sum of two rectangular variables.
Function function_of(const Trapezoidal& p) {
    const double w = 0.5 * (p.high - p.low);
    const double a = 0.5 * w * (1.0 + p.beta), b = 0.5 * w * (1.0 - p.beta);
    return [a, b](double t) { return Complex(sine_over(a * t) * sine_over(b * t)); };
}

Function function_of(const Triangular& t) {
    return function_of(Trapezoidal{t.low, t.high, 0.0});
}

Function function_of(const Arcsine& a) {
    const double w = 0.5 * (a.high - a.low);
    return [w](double t) { return Complex(boost::math::cyl_bessel_j(0, w * std::abs(t))); };
}

Function function_of(const Gamma& g) {
    return [g](double t) {
        const Complex of_mean(0.0, g.shape * g.scale * t);
        return std::exp(-g.shape * std::log(Complex(1.0, -g.scale * t)) - of_mean);
    };
}

Function function_of(const Exponential& e) {
    return function_of(Gamma{1.0, e.mean});
}

Function function_of(const TruncatedNormal& t) {
    if (t.low == t.high || t.standard_deviation == 0.0) return normal_function(0.0);
    return by_quadrature(t);
}

Function function_of(const Lognormal& l) {
    return by_quadrature(l);
}

/// Symmetric: Gamma(a + 1/2) (2/z)^(a - 1/2) J_(a - 1/2)(z), z = w t.
Function function_of(const Beta& b) {
    if (b.low == b.high) return normal_function(0.0);
    if (b.alpha != b.beta || b.alpha > 20.0) return by_quadrature(b);
    const double order = b.alpha - 0.5, w = 0.5 * (b.high - b.low);
    return [order, w](double t) {
        const double z = w * std::abs(t);
        if (z < 1e-3) return Complex(1.0 - z * z / (4.0 * (order + 1.0)));
        return Complex(std::tgamma(order + 1.0) * std::pow(2.0 / z, order) *
                       boost::math::cyl_bessel_j(order, z));
    };
}

Function function_of(const Discrete& d) {
    Nodes nodes{d.values, d.probabilities};
    double whole = 0.0, mean = 0.0;
    for (std::size_t k = 0; k < nodes.x.size(); ++k) {
        whole += nodes.weight[k];
        mean += nodes.weight[k] * nodes.x[k];
    }
    for (double& x : nodes.x) x -= mean / whole;
    for (double& weight : nodes.weight) weight /= whole;
    return nodes;
}

Function function_of(const Laplace& l) {
    return [scale = l.scale](double t) { return Complex(1.0 / (1.0 + scale * scale * t * t)); };
}

Function function_of(const Weibull& w) {
    return w.scale == 0.0 ? normal_function(0.0) : by_quadrature(w);
}

/// exp(lambda (e^iz - 1 - iz)): the cosine less one, and the sine less its argument, keep their digits.
Function function_of(const Poisson& p) {
    return [p](double t) {
        const double z = p.step * t, s = std::sin(0.5 * z);
        return std::exp(p.number * Complex(-2.0 * s * s, std::sin(z) - z));
    };
}

Function function_of(const Binomial& b) {
    return [b](double t) {
        const double z = b.step * t, s = std::sin(0.5 * z);
        const Complex one_trial = 1.0 + b.probability * Complex(-2.0 * s * s, std::sin(z));
        return std::pow(std::abs(one_trial), b.trials) *
               std::polar(1.0, b.trials * (std::arg(one_trial) - b.probability * z));
    };
}

/// The mean of those of its cells.
Function function_of(const StatedHistogram& h) {
    struct Cell {
        double middle, half, probability;
    };
    const double mean = Distribution::of(h).mean();
    double whole = 0.0;
    for (const double probability : h.probabilities) whole += probability;
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < h.probabilities.size(); ++i)
        cells.push_back({0.5 * (h.edges[i] + h.edges[i + 1]) - mean, 0.5 * (h.edges[i + 1] - h.edges[i]),
                         h.probabilities[i] / whole});
    return [cells](double t) {
        Complex sum;
        for (const Cell& cell : cells)
            sum += cell.probability * sine_over(cell.half * t) * std::polar(1.0, cell.middle * t);
        return sum;
    };
}

bool is_by_quadrature(const DistributionParameters& parameters) {
    if (const auto* t = std::get_if<TruncatedNormal>(&parameters))
        return t->low != t->high && t->standard_deviation != 0.0;
    if (const auto* b = std::get_if<Beta>(&parameters))
        return b->low != b->high && (b->alpha != b->beta || b->alpha > 20.0);
    if (const auto* w = std::get_if<Weibull>(&parameters)) return w->scale != 0.0;
    return std::holds_alternative<Lognormal>(parameters);
}

std::function<double(double)> error_of(const DistributionParameters& parameters) {
    if (is_by_quadrature(parameters)) return quadrature_error(Distribution::of(parameters));
    const auto* t = std::get_if<StudentT>(&parameters);
    if (t && std::isfinite(t->degrees_of_freedom) && t->scale != 0.0)
        return [](double) { return error_of_table; };
    return {};
}

}  // namespace

CharacteristicFunction::CharacteristicFunction(const Distribution& distribution)
    : of_parameters_(std::visit([](const auto& p) { return function_of(p); }, distribution.parameters())),
      error_(error_of(distribution.parameters())),
      factor_(distribution.factor()) {}

}  // namespace covaria
