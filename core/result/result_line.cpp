#include "core/result/result_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/special_quantiles.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

ExpandedBy expanded_by(const UncertaintyResult& result) {
    if (result.fixed_coverage_factor) return ExpandedBy::fixed_factor;
    return result.trials > 0 ? ExpandedBy::interval : ExpandedBy::degrees_of_freedom;
}

std::string expanded_key(const UncertaintyResult& result) {
    switch (expanded_by(result)) {
        case ExpandedBy::fixed_factor:
            return "fixed-factor";
        case ExpandedBy::interval:
            return "half-interval";
        case ExpandedBy::degrees_of_freedom:
            break;
    }
    return "effective-degrees-of-freedom";
}

std::string distribution_key(RequirementResult::Distribution distribution) {
    switch (distribution) {
        case RequirementResult::Distribution::trials:
            return "trials";
        case RequirementResult::Distribution::student_t:
            return "student-t";
        case RequirementResult::Distribution::normal:
            break;
    }
    return "normal";
}

Message expanded_words(const UncertaintyResult& result) {
    switch (expanded_by(result)) {
        case ExpandedBy::fixed_factor:
            return tell<"U = k u with the coverage factor that was fixed.">();
        case ExpandedBy::interval:
            return tell<
                "U is half the width of the probabilistically symmetric coverage interval, and k = U/u.">();
        case ExpandedBy::degrees_of_freedom:
            break;
    }
    return tell<"U = k u with k of the t distribution for the effective degrees of freedom.">();
}

bool leaves_out_degrees_of_freedom(const UncertaintyResult& result) {
    if (expanded_by(result) != ExpandedBy::interval) return false;
    return std::any_of(result.inputs->components.begin(), result.inputs->components.end(),
                       [](const UncertaintyComponent& c) {
                           return !c.held && std::isfinite(c.degrees_of_freedom) &&
                                  drawn_distribution(c).kind() == "normal";
                       });
}

CoverageInterval coverage_interval_of(const OutputResult& output, const UncertaintyResult& result) {
    if (output.monte_carlo) return output.monte_carlo->symmetric;
    const FirstOrderOutput& first = output.first_order;
    if (!(first.standard_uncertainty > 0.0)) return {first.estimate, first.estimate};
    // The lower tail is exact near probability 1.
    const double k =
        -t_quantile(0.5 * (1.0 - result.coverage_probability), first.effective_degrees_of_freedom);
    return {first.estimate - k * first.standard_uncertainty, first.estimate + k * first.standard_uncertainty};
}

void state_expanded_uncertainty(OutputResult& output, const UncertaintyResult& result) {
    const double u = output.standard_uncertainty;
    switch (expanded_by(result)) {
        case ExpandedBy::fixed_factor:
            output.coverage_factor = *result.fixed_coverage_factor;
            output.expanded_uncertainty = u > 0.0 ? output.coverage_factor * u : 0.0;
            return;
        case ExpandedBy::interval: {
            const CoverageInterval interval = coverage_interval_of(output, result);
            output.expanded_uncertainty = 0.5 * (interval.high - interval.low);
            output.coverage_factor = output.first_order.coverage_factor;  // a constant has any
            if (u > 0.0)
                output.coverage_factor = std::isfinite(u) ? output.expanded_uncertainty / u
                                                          : std::numeric_limits<double>::quiet_NaN();
            return;
        }
        case ExpandedBy::degrees_of_freedom:
            output.coverage_factor = output.first_order.coverage_factor;
            output.expanded_uncertainty = output.first_order.expanded_uncertainty;
    }
}

double expanded_with(const OutputResult& output, const ContributorResult::Uncertainties& part,
                     std::size_t index) {
    if (!part.monte_carlo.empty()) return output.coverage_factor * part.monte_carlo[index];
    const double u = output.first_order.standard_uncertainty;
    return u > 0.0 ? output.expanded_uncertainty * (part.first_order[index] / u)
                   : output.first_order.coverage_factor * part.first_order[index];
}

}  // namespace covaria
