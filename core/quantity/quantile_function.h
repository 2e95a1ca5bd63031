// Inverse distribution functions as objects: made once for a distribution, applied to whole blocks.
#pragma once

#include <memory>
#include <span>

#include "core/quantity/distribution.h"

namespace covaria::detail {

class QuantileFunction {
public:
    virtual ~QuantileFunction() = default;
    /// x[i] = quantile of p[i]. No allocation; element i depends on p[i] only; `p` and `x` may be the same
    /// memory.
    virtual void at(std::span<const double> p, std::span<double> x) const = 0;
    /// x[i] = quantile of Phi(z[i]), likewise.
    virtual void at_scores(std::span<const double> z, std::span<double> x) const;
};

using QuantileFunctionPointer = std::shared_ptr<const QuantileFunction>;

/// The quantile function for parameters that passed `distribution_problem`.
QuantileFunctionPointer make_quantile_function(const DistributionParameters& parameters);
/// The quantile function of location + factor * X.
QuantileFunctionPointer make_affine(QuantileFunctionPointer of_x, double location, double factor);

// The quantile functions of each kind; all widths are greater than zero.
QuantileFunctionPointer make_curvilinear_trapezoid(const CurvilinearTrapezoid& parameters);
QuantileFunctionPointer make_truncated_normal(const TruncatedNormal& parameters);
QuantileFunctionPointer make_discrete(const Discrete& parameters);
QuantileFunctionPointer make_histogram(const StatedHistogram& parameters);
QuantileFunctionPointer make_student_t(const StudentT& parameters);
QuantileFunctionPointer make_gamma(const Gamma& parameters);
QuantileFunctionPointer make_beta(const Beta& parameters);

/// Their values and probabilities; a step or width of zero is one value.
Discrete table_of(const Poisson& parameters);
Discrete table_of(const Binomial& parameters);

}  // namespace covaria::detail
