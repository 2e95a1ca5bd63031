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
/// quadrature over 2,000 nodes, to 1e-9 for |t| up to some 100 per standard deviation.
class CharacteristicFunction {
public:
    explicit CharacteristicFunction(const Distribution& distribution);
    std::complex<double> operator()(double t) const { return of_parameters_(factor_ * t); }

private:
    std::function<std::complex<double>(double)> of_parameters_;
    double factor_ = 1.0;
};

}  // namespace covaria
