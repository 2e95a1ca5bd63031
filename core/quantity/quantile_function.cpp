// Quantile functions with a closed form, and the choice by kind of distribution.
#include "core/quantity/quantile_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "core/quantity/elementwise_quantile.h"

namespace covaria::detail {

namespace {

QuantileFunctionPointer make_constant(double value) {
    return make_elementwise([value](Batch) { return Batch(value); });
}

QuantileFunctionPointer make(const Normal& n) {
    return make_of_score([n](Batch z) { return Batch(n.mean) + Batch(n.standard_deviation) * z; });
}

QuantileFunctionPointer make(const StudentT& t) {
    if (std::isinf(t.degrees_of_freedom)) return make(Normal{t.mean, t.scale});
    return t.scale == 0.0 ? make_constant(t.mean) : make_student_t(t);
}

QuantileFunctionPointer make(const Rectangular& r) {
    const double width = r.high - r.low;
    return make_symmetric(r.low, r.high, [width](Batch q) { return Batch(width) * q; });
}

/// A ramp over (1 - beta)w at each end, w half the width; then, from p = (1 - beta)/(2(1 + beta)), straight.
QuantileFunctionPointer make(const Trapezoidal& t) {
    const double w = 0.5 * (t.high - t.low);
    const double ramp_probability = 0.5 * (1.0 - t.beta) / (1.0 + t.beta);
    return make_symmetric(t.low, t.high, [=, beta = t.beta](Batch q) {
        const Batch ramp = Batch(w) * xsimd::sqrt(Batch(2.0 * (1.0 - beta) * (1.0 + beta)) * q);
        const Batch straight =
            Batch(w * (1.0 - beta)) + Batch(w * (1.0 + beta)) * (q - Batch(ramp_probability));
        return xsimd::select(q < Batch(ramp_probability), ramp, straight);
    });
}

QuantileFunctionPointer make(const Triangular& t) {
    return make(Trapezoidal{t.low, t.high, 0.0});
}

/// w (1 - cos(pi q)) = 2w sin^2(pi q/2), exact at the ends. The sine is a Taylor polynomial for arguments up
/// to pi/4: the library's may take another route for a lane when its neighbours change.
QuantileFunctionPointer make(const Arcsine& a) {
    constexpr std::array<double, 8> sine{
        1.0,          -1.0 / 6,        1.0 / 120,        -1.0 / 5040,
        1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
    const double width = a.high - a.low;
    return make_symmetric(a.low, a.high, [sine, width](Batch q) {
        const Batch angle = Batch(0.5 * std::numbers::pi) * q;
        const Batch s = angle * polynomial(sine, angle * angle);
        return Batch(width) * s * s;
    });
}

QuantileFunctionPointer make(const CurvilinearTrapezoid& c) {
    return c.inexactness == 0.0 ? make(Rectangular{c.low, c.high}) : make_curvilinear_trapezoid(c);
}

QuantileFunctionPointer make(const Exponential& e) {
    return make_elementwise([mean = e.mean](Batch p) { return Batch(-mean) * xsimd::log1p(-p); });
}

QuantileFunctionPointer make(const Gamma& g) {
    return g.scale == 0.0 ? make_constant(0.0) : make_gamma(g);
}

QuantileFunctionPointer make(const TruncatedNormal& t) {
    if (t.low == t.high || t.standard_deviation == 0.0)
        return make_constant(std::clamp(t.mean, t.low, t.high));
    return make_truncated_normal(t);
}

QuantileFunctionPointer make(const Lognormal& l) {
    return make_of_score(
        [l](Batch z) { return xsimd::exp(Batch(l.log_mean) + Batch(l.log_standard_deviation) * z); });
}

QuantileFunctionPointer make(const Beta& b) {
    return b.low == b.high ? make_constant(b.low) : make_beta(b);
}

QuantileFunctionPointer make(const Discrete& d) {
    return make_discrete(d);
}

/// ln(2p) below the middle, -ln(2(1 - p)) above it.
QuantileFunctionPointer make(const Laplace& l) {
    return make_elementwise([l](Batch p) {
        const Batch distance = xsimd::log(Batch(2.0) * xsimd::min(p, Batch(1.0) - p));
        const Batch sign = xsimd::select(p < Batch(0.5), Batch(l.scale), Batch(-l.scale));
        return Batch(l.mean) + sign * distance;
    });
}

/// (-ln(1 - p))^(1/k), of a mirrored one (-ln p)^(1/k).
QuantileFunctionPointer make(const Weibull& w) {
    if (w.scale == 0.0) return make_constant(w.location);
    return make_elementwise([w, mirrored = w.scale < 0.0](Batch p) {
        const Batch energy = mirrored ? -xsimd::log(p) : -xsimd::log1p(-p);
        return Batch(w.location) + Batch(w.scale) * xsimd::exp(xsimd::log(energy) * Batch(1.0 / w.shape));
    });
}

QuantileFunctionPointer make(const Poisson& p) {
    return make_discrete(table_of(p));
}

QuantileFunctionPointer make(const Binomial& b) {
    return make_discrete(table_of(b));
}

QuantileFunctionPointer make(const StatedHistogram& h) {
    return make_histogram(h);
}

class AffineQuantile final : public QuantileFunction {
public:
    AffineQuantile(QuantileFunctionPointer of_x, double location, double factor)
        : of_x_(std::move(of_x)), location_(location), factor_(factor) {}

    void at(std::span<const double> p, std::span<double> x) const override {
        const bool mirrored = factor_ < 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) x[i] = mirrored ? 1.0 - p[i] : p[i];
        of_x_->at(x, x);
        for (double& value : x) value = location_ + factor_ * value;
    }
    void at_scores(std::span<const double> z, std::span<double> x) const override {
        const double sign = factor_ < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i < z.size(); ++i) x[i] = sign * z[i];
        of_x_->at_scores(x, x);
        for (double& value : x) value = location_ + factor_ * value;
    }

private:
    QuantileFunctionPointer of_x_;
    double location_;
    double factor_;
};

}  // namespace

void QuantileFunction::at_scores(std::span<const double> z, std::span<double> x) const {
    normal_distribution_functions(z, x);
    // Scores beyond 8.3 round to 1, where unbounded distributions end at infinity.
    for (double& p : x) p = std::clamp(p, 0x1p-1000, 1.0 - 0x1p-53);
    at(x, x);
}

QuantileFunctionPointer make_quantile_function(const DistributionParameters& parameters) {
    return std::visit([](const auto& p) { return make(p); }, parameters);
}

QuantileFunctionPointer make_affine(QuantileFunctionPointer of_x, double location, double factor) {
    return std::make_shared<AffineQuantile>(std::move(of_x), location, factor);
}

}  // namespace covaria::detail
