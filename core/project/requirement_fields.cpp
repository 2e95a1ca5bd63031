#include "core/project/requirement_fields.h"

namespace covaria {

const std::vector<GuardRuleChoice>& guard_rules() {
    static const std::vector<GuardRuleChoice> rules{
        {GuardRule::factor, {"factor", "guard factor times U"}},
        {GuardRule::rss, {"rss", "RSS: root of T²/4 − U²"}},
        {GuardRule::rp10, {"rp10", "NCSL RP-10: 1.25 − 1/TUR"}},
        {GuardRule::dobbert, {"dobbert", "managed (Dobbert): at most 2 % false accepts"}},
        {GuardRule::specific_risk, {"specific-risk", "to a specific risk at the acceptance limit"}},
        {GuardRule::global_risk, {"global-risk", "to a global consumer's risk"}},
        {GuardRule::accepted_risk, {"accepted-risk", "to a risk of what is accepted"}}};
    return rules;
}

const std::array<RequirementField, 8>& requirement_fields() {
    static const std::array<RequirementField, 8> fields{{
        {"targetUncertainty", "Target uncertainty", "The expanded uncertainty U must not exceed this.",
         &Requirement::target_uncertainty, true},
        {"lowerLimit", "Lower limit", "Of the tolerance; empty: none.", &Requirement::lower_limit},
        {"upperLimit", "Upper limit", "Of the tolerance; empty: none.", &Requirement::upper_limit},
        {"guardFactor", "Guard factor",
         "Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple "
         "acceptance, "
         "negative values favour the producer.",
         &Requirement::guard_factor},
        {"guardRule", "Guard band",
         "How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits "
         "are "
         "needed), or so narrow as a target risk allows (global risks need a prior).",
         &Requirement::guard_rule},
        {"targetRisk", "Target risk", "That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.",
         &Requirement::target_risk},
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

namespace {

template <class M>
void add_member(JsonFields<Requirement>& fields, const char* key, M Requirement::*member) {
    fields.add(key, member);
}

void add_member(JsonFields<Requirement>& fields, const char* key, GuardRule Requirement::*member) {
    OneOf<GuardRule> words;
    for (const GuardRuleChoice& known : guard_rules())
        words.words.push_back({known.rule, known.choice.key.c_str()});
    fields.add(key, member, words);
}

}  // namespace

const JsonFields<Requirement>& requirement_object() {
    static const auto fields = [] {
        JsonFields<Requirement> made(tell<"a requirement">(), JsonWriter::Style::one_line);
        made.add("group", &Requirement::group).required("symbol", &Requirement::symbol);
        for (const RequirementField& field : requirement_fields())
            std::visit([&](auto member) { add_member(made, field.key, member); }, field.member);
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
