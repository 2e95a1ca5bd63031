// Checks of the inputs before anything is computed.
#include <cmath>
#include <string>

#include "core/propagation/engine_parts.h"

namespace covaria::detail {
namespace {

Result<void> check_component(const UncertaintyComponent& component, const std::string& path) {
    if (!(component.degrees_of_freedom > 0))
        return fail(ErrorCode::bad_input,
                    tell<"the degrees of freedom of %1 must be greater than zero">(component.id),
                    path + "/degrees_of_freedom");
    const bool normal = component.distribution.kind() == "normal";
    if (normal && !Distribution::make(StudentT{0.0, 1.0, component.degrees_of_freedom}))
        return fail(
            ErrorCode::bad_input,
            tell<"the degrees of freedom of %1 are too few: there must be at least 0.2">(component.id),
            path + "/degrees_of_freedom");
    if (!std::isfinite(component.distribution.mean()) ||
        !std::isfinite(component.distribution.standard_uncertainty()))
        return fail(ErrorCode::bad_input,
                    tell<"the distribution of %1 has no finite mean or standard uncertainty">(component.id),
                    path + "/distribution");
    return {};
}

Result<void> check_quantity(const InputQuantity& quantity, std::size_t components, const std::string& path) {
    if (!std::isfinite(quantity.offset))
        return fail(ErrorCode::bad_input, tell<"the estimate of %1 is not a finite number">(quantity.symbol),
                    path + "/offset");
    for (const Share& share : quantity.shares)
        if (share.component >= components || !std::isfinite(share.factor))
            return fail(ErrorCode::bad_input,
                        tell<"quantity %1 refers to a component that does not exist, or with a factor that "
                             "is not finite">(quantity.symbol),
                        path + "/shares");
    return {};
}

}  // namespace

Result<Correlations> checked_correlations(const MeasurementModel& model, const InputSet& inputs) {
    if (inputs.quantities.size() != model.inputs().quantities.size())
        return fail(ErrorCode::bad_input,
                    tell<"the measurement model has %1 input quantities, but %2 were given">(
                        model.inputs().quantities.size(), inputs.quantities.size()),
                    "/quantities");
    if (model.outputs().empty())
        return fail(ErrorCode::bad_input, tell<"the measurement model has no output quantities">());
    for (std::size_t c = 0; c < inputs.components.size(); ++c)
        if (auto ok = check_component(inputs.components[c], "/components/" + std::to_string(c)); !ok)
            return fail(ok.error());
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
        if (auto ok = check_quantity(inputs.quantities[i], inputs.components.size(),
                                     "/quantities/" + std::to_string(i));
            !ok)
            return fail(ok.error());
    return resolved_correlations(inputs);
}

}  // namespace covaria::detail
