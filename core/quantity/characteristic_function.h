// Characteristic functions of distributions: what the distribution of a sum of independent components is made
// of.
#pragma once

#include <complex>
#include <functional>

#include "core/quantity/distribution.h"

namespace covaria {

/// E exp(i t (X - m)) with m the mean of the distribution (of a Student t its centre). Closed forms where
/// there are any (all distributions of JCGM 101 table 1, symmetric beta, discrete); Student t to 1e-9 from a
/// table of its scale mixture of normal distributions; truncated normal, lognormal and unsymmetric beta by
/// quadrature over 2,000 nodes, which loses its digits where exp(i t X) turns faster than from node to node.
class CharacteristicFunction {
public:
    explicit CharacteristicFunction(const Distribution& distribution);
    std::complex<double> operator()(double t) const { return of_parameters_(factor_ * t); }
    /// Bound of the error of the value at t.
    double error(double t) const { return error_ ? error_(factor_ * t) : rounding; }

private:
    static constexpr double rounding = 1e-15;
    std::function<std::complex<double>(double)> of_parameters_;
    std::function<double(double)> error_;  ///< empty: a closed form
    double factor_ = 1.0;
};

}  // namespace covaria
