// Checks of the evaluation options.
#include "core/propagation/options.h"

#include <cmath>
#include <string>

#include "core/propagation/adaptive.h"

namespace covaria {
namespace {

void check_adaptive(const EvaluationOptions& options, Problems& problems) {
    if (options.significant_digits < 1 || options.significant_digits > 4)
        problems.error(
            "/significant_digits",
            tell<"the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4">());
    if (options.tolerance && !(options.tolerance->value > 0 && std::isfinite(options.tolerance->value)))
        problems.error("/tolerance", tell<"the numerical tolerance must be greater than zero">());
    if (options.minimum_batches < 2)
        problems.error("/minimum_batches", tell<"the adaptive procedure needs at least two batches">());
    const bool known = options.coverage_probability > 0 && options.coverage_probability < 1 - 1e-9;
    const std::uint64_t batch =
        known ? detail::AdaptiveProcedure::batch_trials(options.coverage_probability) : 0;
    if (options.method == Method::adaptive && options.maximum_trials / 2 < batch)
        problems.error(
            "/maximum_trials",
            tell<"the adaptive procedure needs at least two batches: allow %1 trials or more">(2 * batch));
}

}  // namespace

void EvaluationOptions::check(Problems& problems) const {
    if (method == Method::monte_carlo && trials < 2)
        problems.error("/trials", tell<"a Monte Carlo run needs at least two trials">());
    if (!(coverage_probability > 0 && coverage_probability < 1))
        problems.error("/coverage_probability", tell<"the coverage probability must lie between 0 and 1">());
    else if (coverage_probability > 1 - 1e-9)
        problems.error("/coverage_probability", tell<"the coverage probability is too near to 1">());
    if (coverage_factor && !(*coverage_factor > 0 && std::isfinite(*coverage_factor)))
        problems.error("/coverage_factor", tell<"the coverage factor must be greater than zero">());
    if (one_at_a_time_trials == 1)
        problems.error("/one_at_a_time_trials",
                       tell<"one-at-a-time Monte Carlo needs at least two trials">());
    if (contributor_trials == 1)
        problems.error("/contributor_trials",
                       tell<"Monte Carlo without a contributor needs at least two trials">());
    if (sobol_trials > 0 && sobol_trials < 100)
        problems.error("/sobol_trials", tell<"Sobol indices need at least 100 trials">());
    check_adaptive(*this, problems);
}

std::optional<double> EvaluationOptions::tolerance_for(const Unit& unit) const {
    if (!tolerance) return {};
    const bool applies =
        tolerance->unit.dimension().is_one() || tolerance->unit.dimension() == unit.dimension();
    return applies ? std::optional(tolerance->unit.interval_to_si(tolerance->value)) : std::nullopt;
}

}  // namespace covaria
