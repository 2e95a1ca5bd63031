// Quantiles of Student's t, chi-squared and F, and the coverage factors made of them (JCGM 100 Annex G, JCGM
// 102 6.5).
#pragma once

#include "core/base/error.h"

namespace covaria {

/// t_p(nu) for 0 < p < 1; `nu` may be infinite (the normal distribution). NaN unless 0 < p < 1 and nu > 0.
double t_quantile(double p, double nu);
/// Distribution function of Student's t; `nu` may be infinite. To full relative precision in the lower tail.
/// NaN unless nu > 0.
double t_distribution_function(double t, double nu);
/// Density of Student's t; `nu` may be infinite. NaN unless nu > 0.
double t_density(double t, double nu);
/// Quantile of chi-squared with `dof` degrees of freedom. NaN unless 0 < p < 1 and 0 < dof < infinity.
double chi_squared_quantile(double p, double dof);
/// Probability that chi-squared exceeds `value` >= 0: the p of a chi-squared test. NaN unless 0 < dof <
/// infinity.
double chi_squared_upper_tail(double value, double dof);
/// Quantile of F; `nu2` may be infinite (chi-squared over nu1). NaN unless 0 < p < 1 and both are positive.
double f_quantile(double p, double nu1, double nu2);
/// Probability that F exceeds `ratio` >= 0: the p of an F-test. NaN unless 0 < nu1, nu2 < infinity.
double f_upper_tail(double ratio, double nu1, double nu2);

/// k of a probabilistically symmetric coverage interval: t at (1 + probability)/2 (JCGM 100 G.3, G.4).
/// Errors: probability not inside (0, 1), degrees of freedom not positive.
Result<double> coverage_factor(double probability, double nu);

}  // namespace covaria
