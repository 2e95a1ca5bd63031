#include "core/propagation/take_trials.h"

#include <algorithm>

#include "core/result/result_line.h"

namespace covaria::detail {

double smallest_degrees_of_freedom(const InputSet& inputs, const LawOfPropagation& law, std::size_t output,
                                   const OutputQuantity& quantity) {
    double smallest = infinity;
    if (quantity.periodic) return smallest;
    for (const PropagationTerm& term : law.terms[output]) {
        const UncertaintyComponent& component = inputs.components[term.component];
        if (term.contribution != 0.0 && !component.held)
            smallest = std::min(smallest, component.distribution.degrees_of_freedom());
    }
    return smallest;
}

void take_trials(OutputResult& output, MonteCarloOutput trials, double degrees_of_freedom,
                 const UncertaintyResult& result) {
    if (degrees_of_freedom <= 2.0) trials.standard_uncertainty = infinity;
    output.estimate = degrees_of_freedom <= 1.0 ? output.first_order.estimate : trials.mean;
    output.standard_uncertainty = trials.standard_uncertainty;
    output.monte_carlo = std::move(trials);
    state_expanded_uncertainty(output, result);
}

}  // namespace covaria::detail
