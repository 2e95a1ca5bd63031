// Quantiles of Student's t, chi-squared and F by Boost.Math, and coverage factors.
#include "core/math/special_quantiles.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "core/math/normal_quantile.h"

namespace covaria {

namespace {

namespace policies = boost::math::policies;

// Overflow gives infinity and a bad argument NaN, as the standard library does; no exceptions.
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>,
                     policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

bool is_probability(double p) {
    return p > 0.0 && p < 1.0;
}

}  // namespace

double t_quantile(double p, double nu) {
    if (!is_probability(p) || !(nu > 0.0)) return nan_value;
    // Beyond 1e9 degrees of freedom t differs from the normal by less than z^2/(4 nu), out of reach of any
    // data.
    if (nu > 1e15) return normal_quantile(p);
    return boost::math::quantile(boost::math::students_t_distribution<double, Quiet>(nu), p);
}

double t_distribution_function(double t, double nu) {
    if (!(nu > 0.0) || std::isnan(t)) return nan_value;
    if (std::isinf(t)) return t > 0.0 ? 1.0 : 0.0;
    if (nu > 1e15) return normal_distribution_function(t);
    return boost::math::cdf(boost::math::students_t_distribution<double, Quiet>(nu), t);
}

double t_density(double t, double nu) {
    if (!(nu > 0.0) || std::isnan(t)) return nan_value;
    if (nu > 1e15) return normal_density(t);
    return boost::math::pdf(boost::math::students_t_distribution<double, Quiet>(nu), t);
}

double chi_squared_quantile(double p, double dof) {
    if (!is_probability(p) || !(dof > 0.0) || std::isinf(dof)) return nan_value;
    return boost::math::quantile(boost::math::chi_squared_distribution<double, Quiet>(dof), p);
}

double chi_squared_upper_tail(double value, double dof) {
    if (!(value >= 0.0) || !(dof > 0.0) || std::isinf(dof)) return nan_value;
    return boost::math::cdf(
        boost::math::complement(boost::math::chi_squared_distribution<double, Quiet>(dof), value));
}

double f_quantile(double p, double nu1, double nu2) {
    if (!is_probability(p) || !(nu1 > 0.0) || !(nu2 > 0.0) || std::isinf(nu1)) return nan_value;
    if (std::isinf(nu2)) return chi_squared_quantile(p, nu1) / nu1;
    return boost::math::quantile(boost::math::fisher_f_distribution<double, Quiet>(nu1, nu2), p);
}

double f_upper_tail(double ratio, double nu1, double nu2) {
    if (!(ratio >= 0.0) || !(nu1 > 0.0) || !(nu2 > 0.0) || std::isinf(nu1) || std::isinf(nu2))
        return nan_value;
    return boost::math::cdf(
        boost::math::complement(boost::math::fisher_f_distribution<double, Quiet>(nu1, nu2), ratio));
}

Result<double> coverage_factor(double probability, double nu) {
    if (!is_probability(probability))
        return fail(ErrorCode::bad_input, tell<"the coverage probability must lie between 0 and 1.">());
    if (!(nu > 0.0))
        return fail(ErrorCode::bad_input, tell<"the effective degrees of freedom must be greater than 0.">());
    // The lower tail is taken: 1 - probability is exact near 1, (1 + probability)/2 is not.
    return -t_quantile(0.5 * (1.0 - probability), nu);
}

}  // namespace covaria
