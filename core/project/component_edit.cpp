#include "core/project/component_edit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace covaria {

namespace {

/// The value without the tail of digits that a conversion leaves: 0.5 um are 0.0005 mm.
double rounded_to_15_digits(double value) {
    if (!std::isfinite(value)) return value;
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 15);
    std::from_chars(text.data(), end.ptr, value);
    return value;
}

/// The parameters converted. Those without a unit stay: degrees of freedom, those of a lognormal distribution
/// (of the number in SI), and the probabilities of distributions with lists, which have the values or edges
/// first.
template <class Convert>
std::vector<double> converted_parameters(const ComponentEdit& edit, Convert convert) {
    std::vector<double> parameters = edit.parameters;
    const DistributionKindInfo* kind = find_distribution_kind(edit.distribution);
    if (!kind) return parameters;
    const bool lists = kind->parameters.empty();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool has_unit = lists ? i < first_list_size(parameters.size())
                                    : i < kind->parameters.size() && kind->parameters[i].has_unit;
        if (has_unit) parameters[i] = convert(parameters[i]);
    }
    return parameters;
}

}  // namespace

Result<Distribution> distribution_of(const ComponentEdit& edit) {
    return distribution_from(edit.distribution, converted_parameters(edit, [&](double value) {
                                 return edit.unit.interval_to_si(value);
                             }));
}

double degrees_of_freedom_of(const ComponentEdit& edit, const Distribution& distribution) {
    return edit.degrees_of_freedom.value_or(distribution.degrees_of_freedom());
}

Result<Distribution> drawn_distribution(const ComponentEdit& edit, bool normal_draws) {
    return distribution_of(edit).map([&](const Distribution& stated) {
        UncertaintyComponent component;
        component.distribution = stated;
        component.degrees_of_freedom = degrees_of_freedom_of(edit, stated);
        component.normal_draws = normal_draws;
        return drawn_distribution(component);
    });
}

void set_distribution(ComponentEdit& edit, const Distribution& distribution) {
    edit.distribution = distribution.kind();
    edit.parameters = distribution_parameters(distribution);
    edit.parameters = converted_parameters(
        edit, [&](double value) { return rounded_to_15_digits(edit.unit.interval_from_si(value)); });
}

ComponentEdit in_unit(ComponentEdit edit, const Unit& unit) {
    if (unit == edit.unit) return edit;
    edit.parameters = converted_parameters(edit, [&](double value) {
        return rounded_to_15_digits(unit.interval_from_si(edit.unit.interval_to_si(value)));
    });
    edit.unit = unit;
    return edit;
}

ComponentEdit to_edit(const UncertaintyComponent& component, const DocumentLanguage& in) {
    ComponentEdit edit;
    edit.name = in.say(component.name);
    edit.unit = component.unit.interval();
    edit.type = component.type;
    edit.origin = in.say(component.origin);
    if (std::isfinite(component.degrees_of_freedom)) edit.degrees_of_freedom = component.degrees_of_freedom;
    set_distribution(edit, component.distribution);
    return edit;
}

}  // namespace covaria
