// The first-order part of a result, from the law of propagation.
#include <cmath>
#include <string>

#include "core/base/version.h"
#include "core/propagation/contributions.h"
#include "core/propagation/coverage_regions.h"
#include "core/propagation/engine_parts.h"
#include "core/quantity/isotropic_vector.h"
#include "core/result/result_line.h"

namespace covaria::detail {
namespace {

std::string label(const OutputQuantity& quantity) {
    return quantity.group.empty() ? quantity.symbol : quantity.symbol + " (" + quantity.group + ")";
}

/// Whether nothing is lost by drawing the coordinates independently: they are constants, or normal and alike.
bool is_independent(const InputSet& inputs, const IsotropicVector& vector) {
    const auto distribution = [&](std::size_t axis) -> const Distribution& {
        return inputs.components[vector.components[axis]].distribution;
    };
    const bool alike = distribution(0) == distribution(1) && distribution(1) == distribution(2);
    return alike && (distribution(0).standard_deviation() == 0.0 || distribution(0).kind() == "normal");
}

void warn(const LawOfPropagation& law, UncertaintyResult& result) {
    if (law.degrees_of_freedom_approximate)
        result.warnings.push_back(
            tell<"Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes "
                 "independent components, and correlated components with finite degrees of freedom "
                 "contribute. The Monte Carlo coverage interval is the better guide.">());
    std::size_t torn = result.inputs->vectors.size() - vectors_of_random_direction(result.inputs).size();
    for (const IsotropicVector& vector : result.inputs->vectors)
        if (is_independent(result.inputs, vector)) --torn;
    if (torn > 0)
        result.warnings.push_back(
            torn == 1 ? tell<"1 vector of random direction has coordinates with different distributions "
                             "after editing: they are drawn independently.">()
                      : tell<"%1 vectors of random direction have coordinates with different distributions "
                             "after editing: they are drawn independently.">(torn));
    for (const OutputResult& output : result.outputs)
        if (output.quantity.periodic && output.first_order.standard_uncertainty > 1.0)
            result.warnings.push_back(tell<"The angle %1 is hardly determined: its standard uncertainty by "
                                           "the law of propagation exceeds 1 rad.">(label(output.quantity)));
}

}  // namespace

OutputResult output_result(const OutputQuantity& quantity, const LawOfPropagation& law, Eigen::Index j,
                           const EvaluationOptions& options) {
    OutputResult output;
    output.quantity = quantity;
    FirstOrderOutput& first = output.first_order;
    first.estimate = law.estimate(j);
    first.standard_uncertainty = law.uncertainty(j);
    first.effective_degrees_of_freedom = law.degrees_of_freedom(j);
    first.coverage_factor = options.coverage_factor.value_or(
        coverage_factor_of(options.coverage_probability, first.effective_degrees_of_freedom));
    first.expanded_uncertainty = first.coverage_factor * first.standard_uncertainty;
    output.estimate = first.estimate;
    output.standard_uncertainty = first.standard_uncertainty;
    return output;
}

Result<UncertaintyResult> first_order_result(const MeasurementModel& model, const SharedInputs& inputs,
                                             const EvaluationOptions& options, const LawOfPropagation& law) {
    UncertaintyResult result;
    result.inputs = inputs;
    result.coverage_probability = options.coverage_probability;
    result.fixed_coverage_factor = options.coverage_factor;
    result.provenance.covaria_version = version();
    result.provenance.seed = options.seed;
    for (Eigen::Index j = 0; j < law.estimate.size(); ++j)
        result.outputs.push_back(
            output_result(model.outputs()[static_cast<std::size_t>(j)], law, j, options));
    for (OutputResult& output : result.outputs) state_expanded_uncertainty(output, result);
    result.covariance = law.covariance;
    result.budget = budget_of(inputs, law);
    result.regions = declare_regions(model.outputs(), law, options.coverage_probability);
    warn(law, result);
    return result;
}

}  // namespace covaria::detail
