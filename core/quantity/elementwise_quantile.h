// Quantile functions that are a formula of xsimd batches, element by element.
#pragma once

#include <utility>

#include "core/math/batch_transform.h"
#include "core/math/normal_quantile.h"
#include "core/quantity/quantile_function.h"

namespace covaria::detail {

using Batch = xsimd::batch<double>;

/// x = formula(p).
template <class Formula>
class ElementwiseQuantile final : public QuantileFunction {
public:
    explicit ElementwiseQuantile(Formula formula) : formula_(std::move(formula)) {}
    void at(std::span<const double> p, std::span<double> x) const override {
        transform_batches(p, x, 0.5, formula_);
    }

private:
    Formula formula_;
};

/// x = formula(z) of the normal score z.
template <class Formula>
class ScoreQuantile final : public QuantileFunction {
public:
    explicit ScoreQuantile(Formula formula) : formula_(std::move(formula)) {}
    void at(std::span<const double> p, std::span<double> x) const override {
        normal_quantiles(p, x);
        transform_batches(x, x, 0.0, formula_);
    }
    void at_scores(std::span<const double> z, std::span<double> x) const override {
        transform_batches(z, x, 0.0, formula_);
    }

private:
    Formula formula_;
};

template <class Formula>
QuantileFunctionPointer make_elementwise(Formula formula) {
    return std::make_shared<ElementwiseQuantile<Formula>>(std::move(formula));
}

template <class Formula>
QuantileFunctionPointer make_of_score(Formula formula) {
    return std::make_shared<ScoreQuantile<Formula>>(std::move(formula));
}

/// Keeps x within limits that rounding might cross by a bit.
inline Batch clamped(Batch x, double low, double high) {
    return xsimd::min(xsimd::max(x, Batch(low)), Batch(high));
}

/// The p quantile of a distribution symmetric between `low` and `high`: `from_end(q)` is the distance of the
/// q quantile from its end for q <= 1/2.
template <class FromEnd>
Batch symmetric(Batch p, double low, double high, const FromEnd& from_end) {
    const Batch distance = from_end(xsimd::min(p, Batch(1.0) - p));
    const Batch x = xsimd::select(p < Batch(0.5), Batch(low) + distance, Batch(high) - distance);
    return clamped(x, low, high);
}

template <class FromEnd>
QuantileFunctionPointer make_symmetric(double low, double high, FromEnd from_end) {
    return make_elementwise([=](Batch p) { return symmetric(p, low, high, from_end); });
}

}  // namespace covaria::detail
