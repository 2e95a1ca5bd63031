// The standard normal distribution: density, distribution function and its inverse, for single values and for
// spans.
#pragma once

#include <span>

#include "core/base/processor.h"

namespace covaria {

/// Density exp(-z^2/2)/sqrt(2 pi).
double normal_density(double z);
/// Phi(z), to full relative precision in the lower tail.
double normal_distribution_function(double z);
/// Inverse of Phi for 0 < p < 1, to about 1e-15 relative: Wichura, Algorithm AS 241 (PPND16), Applied
/// Statistics 37 (1988) 477-484. Gives -inf and inf at 0 and 1, NaN outside.
double normal_quantile(double p);

/// z[i] = normal_quantile(p[i]), bit-identical with the single form, vectorised, without allocation. Same
/// length; may be the same memory.
void normal_quantiles(std::span<const double> p, std::span<double> z);
/// p[i] = Phi(z[i]), vectorised in the same way: 5e-15 absolute, 1e-11 relative in the lower tail.
void normal_distribution_functions(std::span<const double> z, std::span<double> p);

namespace detail {

/// The two forms of normal_quantiles, with the same bits; the second needs has_avx512().
void normal_quantiles_avx2(std::span<const double> p, std::span<double> z);
void normal_quantiles_avx512(std::span<const double> p, std::span<double> z);

}  // namespace detail

}  // namespace covaria
