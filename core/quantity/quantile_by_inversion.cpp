// Quantile functions without a closed form that are quick to invert: curvilinear trapezoid, truncated normal,
// discrete.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/quantity/elementwise_quantile.h"

namespace covaria::detail {

namespace {

/// e in [0, 1] with e + (1 - e) ln(1 - e) = y, for y in [0, 1]. The function is convex with slope -ln(1 - e).
/// Start: series in s = sqrt(2y), its last term chosen for e(1) = 1; four Newton steps then leave less than
/// 1e-14.
Batch inverted_ramp(Batch y) {
    constexpr double nearly_one = 1.0 - 0x1p-53;
    constexpr double least = 1e-150;  // keeps 0/0 out of the step at y = 0
    const Batch s = xsimd::sqrt(Batch(2.0) * y);
    Batch e = s * (Batch(1.0) - s * (Batch(1.0 / 6) + s * (Batch(1.0 / 72) + s * Batch(0.0104))));
    for (int step = 0; step < 4; ++step) {
        e = clamped(e, least, nearly_one);
        const Batch slope = -xsimd::log1p(-e);
        const Batch value = e - (Batch(1.0) - e) * slope;
        e = e - (value - y) / slope;
    }
    return clamped(e, 0.0, 1.0);
}

class DiscreteQuantile final : public QuantileFunction {
public:
    explicit DiscreteQuantile(const Discrete& d) {
        std::vector<std::size_t> order(d.values.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return d.values[a] < d.values[b]; });
        double sum = 0.0;
        for (const std::size_t i : order) {
            if (d.probabilities[i] == 0.0) continue;
            values_.push_back(d.values[i]);
            cumulative_.push_back(sum += d.probabilities[i]);
        }
        for (double& c : cumulative_) c /= sum;
    }

    void at(std::span<const double> p, std::span<double> x) const override {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto place = std::lower_bound(cumulative_.begin(), cumulative_.end() - 1, p[i]);
            x[i] = values_[static_cast<std::size_t>(place - cumulative_.begin())];
        }
    }

private:
    std::vector<double> values_;      ///< rising
    std::vector<double> cumulative_;  ///< rising to 1
};

/// On the lower ramp, with w half the width, d the inexactness, c = w + d and x = centre - c(1 - e), the
/// distribution function is (c/4d)(e + (1 - e) ln(1 - e)), the integral of the density of JCGM 101 6.4.3;
/// straight between the ramps, which alone are inverted.
class CurvilinearTrapezoidQuantile final : public QuantileFunction {
public:
    explicit CurvilinearTrapezoidQuantile(const CurvilinearTrapezoid& t)
        : low_(t.low - t.inexactness),
          high_(t.high + t.inexactness),
          d_(t.inexactness),
          c_(0.5 * (t.high - t.low) + d_),
          inner_(0.5 * (t.high - t.low) - d_),
          top_(inner_ > 0.0 ? std::log(c_ / inner_) / (4.0 * d_) : infinity),
          ramp_probability_(inner_ > 0.0 ? 0.5 - inner_ * top_ : infinity) {}

    void at(std::span<const double> p, std::span<double> x) const override {
        const auto from_end = [this](Batch q) { return Batch(c_) - (Batch(0.5) - q) / Batch(top_); };
        const auto on_ramp = [this](Batch q) {
            return Batch(c_) * inverted_ramp(xsimd::min(Batch(4.0 * d_ / c_) * q, Batch(1.0)));
        };
        for_chunks(p, x, [&](std::span<const double> from, std::span<double> to) {
            SetApart ramps;
            ramps.gather(from, [this](double u) { return std::min(u, 1.0 - u) < ramp_probability_; });
            transform_batches(from, to, 0.5, [&](Batch u) { return symmetric(u, low_, high_, from_end); });
            ramps.transform(to, 0.01, [&](Batch u) { return symmetric(u, low_, high_, on_ramp); });
        });
    }

private:
    double low_, high_, d_, c_;
    double inner_;  ///< half the length of the flat top
    double top_;    ///< density there
    double ramp_probability_;
};

class TruncatedNormalQuantile final : public QuantileFunction {
public:
    explicit TruncatedNormalQuantile(const TruncatedNormal& t) : parameters_(t) {
        const double a = (t.low - t.mean) / t.standard_deviation;
        const double b = (t.high - t.mean) / t.standard_deviation;
        // Mirrored so that the greater part lies in the lower tail, where probabilities have all their
        // digits.
        mirrored_ = a + b > 0.0;
        below_ = normal_distribution_function(mirrored_ ? -b : a);
        between_ = normal_distribution_function(mirrored_ ? -a : b) - below_;
    }

    void at(std::span<const double> p, std::span<double> x) const override {
        transform_batches(p, x, 0.5, [this](Batch u) {
            const Batch v = mirrored_ ? Batch(1.0) - u : u;
            return Batch(below_) + Batch(between_) * v;
        });
        normal_quantiles(x, x);
        const double scale = mirrored_ ? -parameters_.standard_deviation : parameters_.standard_deviation;
        transform_batches(x, x, 0.0, [this, scale](Batch z) {
            return clamped(Batch(parameters_.mean) + Batch(scale) * z, parameters_.low, parameters_.high);
        });
    }

private:
    TruncatedNormal parameters_;
    bool mirrored_ = false;
    double below_ = 0.0;
    double between_ = 1.0;
};

}  // namespace

QuantileFunctionPointer make_curvilinear_trapezoid(const CurvilinearTrapezoid& parameters) {
    return std::make_shared<CurvilinearTrapezoidQuantile>(parameters);
}

QuantileFunctionPointer make_truncated_normal(const TruncatedNormal& parameters) {
    return std::make_shared<TruncatedNormalQuantile>(parameters);
}

QuantileFunctionPointer make_discrete(const Discrete& parameters) {
    return std::make_shared<DiscreteQuantile>(parameters);
}

}  // namespace covaria::detail
