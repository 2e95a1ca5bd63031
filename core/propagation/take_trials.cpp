#include "core/propagation/take_trials.h"

#include <limits>

#include "core/result/result_line.h"

namespace covaria::detail {

void take_trials(OutputResult& output, MonteCarloOutput trials, double degrees_of_freedom,
                 const UncertaintyResult& result) {
    if (output.quantity.periodic) degrees_of_freedom = infinity;  // an angle is bounded by its branch
    if (degrees_of_freedom <= 2.0) {
        trials.standard_uncertainty = infinity;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        trials.standard_error_of_mean = trials.standard_error_of_uncertainty = none;
    }
    output.estimate = degrees_of_freedom <= 1.0 ? output.first_order.estimate : trials.mean;
    output.standard_uncertainty = trials.standard_uncertainty;
    output.monte_carlo = std::move(trials);
    state_expanded_uncertainty(output, result);
}

}  // namespace covaria::detail
