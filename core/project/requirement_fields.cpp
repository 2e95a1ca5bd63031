#include "core/project/requirement_fields.h"

namespace covaria {

const std::array<RequirementField, 6>& requirement_fields() {
    static const std::array<RequirementField, 6> fields{{
        {"targetUncertainty", "Target uncertainty", "The expanded uncertainty U must not exceed this.",
         &Requirement::target_uncertainty, true},
        {"lowerLimit", "Lower limit", "Of the tolerance; empty: none.", &Requirement::lower_limit},
        {"upperLimit", "Upper limit", "Of the tolerance; empty: none.", &Requirement::upper_limit},
        {"guardFactor", "Guard factor",
         "Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple "
         "acceptance, "
         "negative values favour the producer.",
         &Requirement::guard_factor},
        {"priorMean", "Prior mean",
         "What is known of such quantities before the measurement, as a normal distribution (the production "
         "process): for "
         "the global risks of JCGM 106.",
         &Requirement::prior_mean},
        {"priorStandardDeviation", "Prior standard deviation", "Of the production process.",
         &Requirement::prior_standard_deviation, true},
    }};
    return fields;
}

const JsonFields<Requirement>& requirement_object() {
    static const auto fields = [] {
        JsonFields<Requirement> made(tell<"a requirement">(), JsonWriter::Style::one_line);
        made.add("group", &Requirement::group).required("symbol", &Requirement::symbol);
        for (const RequirementField& field : requirement_fields())
            std::visit([&](auto member) { made.add(field.key, member); }, field.member);
        return made;
    }();
    return fields;
}

std::optional<Quantity> value_of(const Requirement& requirement, const RequirementField& field) {
    if (const auto* number = std::get_if<double Requirement::*>(&field.member))
        return Quantity{requirement.**number, Unit{}};
    return requirement.*std::get<std::optional<Quantity> Requirement::*>(field.member);
}

void set_value(Requirement& requirement, const RequirementField& field,
               const std::optional<Quantity>& value) {
    if (const auto* number = std::get_if<double Requirement::*>(&field.member))
        requirement.** number = value ? value->si() : Requirement{}.**number;
    else
        requirement.*std::get<std::optional<Quantity> Requirement::*>(field.member) = value;
}

}  // namespace covaria
