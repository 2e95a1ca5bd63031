// Validation of the law of propagation by Monte Carlo.
#include "core/propagation/validation.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/propagation/first_order.h"
#include "core/propagation/numerical_tolerance.h"

namespace covaria::detail {

FirstOrderOutput::Validation validation_of(const FirstOrderOutput& first_order,
                                           const CoverageInterval& symmetric, double probability,
                                           const Unit& unit, int digits, std::uint64_t trials) {
    const double u = first_order.standard_uncertainty;
    const double expanded =
        u > 0 ? coverage_factor_of(probability, first_order.effective_degrees_of_freedom) * u : 0.0;
    FirstOrderOutput::Validation validation;
    validation.tolerance = numerical_tolerance(u, unit, digits);
    validation.d_low = std::abs(first_order.estimate - expanded - symmetric.low);
    validation.d_high = std::abs(first_order.estimate + expanded - symmetric.high);
    validation.validated =
        validation.d_low <= validation.tolerance && validation.d_high <= validation.tolerance;
    const double tail = 0.5 * (1.0 - probability);
    const double standard_error = u * std::sqrt(tail * (1.0 - tail) / static_cast<double>(trials)) /
                                  normal_density(normal_quantile(tail));
    const double d = std::max(validation.d_low, validation.d_high);
    validation.is_close = std::abs(d - validation.tolerance) <= 2.0 * standard_error;
    return validation;
}

}  // namespace covaria::detail
