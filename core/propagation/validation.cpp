// Validation of the law of propagation by Monte Carlo.
#include "core/propagation/validation.h"

#include <cmath>

#include "core/propagation/first_order.h"
#include "core/propagation/numerical_tolerance.h"

namespace covaria::detail {

FirstOrderOutput::Validation validation_of(const FirstOrderOutput& first_order,
                                           const CoverageInterval& symmetric, double probability,
                                           const Unit& unit, int digits) {
    const double u = first_order.standard_uncertainty;
    const double expanded =
        u > 0 ? coverage_factor_of(probability, first_order.effective_degrees_of_freedom) * u : 0.0;
    FirstOrderOutput::Validation validation;
    validation.tolerance = numerical_tolerance(u, unit, digits);
    validation.d_low = std::abs(first_order.estimate - expanded - symmetric.low);
    validation.d_high = std::abs(first_order.estimate + expanded - symmetric.high);
    validation.validated =
        validation.d_low <= validation.tolerance && validation.d_high <= validation.tolerance;
    return validation;
}

}  // namespace covaria::detail
