#include "core/project/stated_requirements.h"

#include <algorithm>
#include <cmath>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/project/analysis_fields.h"
#include "core/project/requirement_fields.h"
#include "core/setup/difference_remedy.h"
#include "core/setup/message_text.h"
#include "core/setup/setup_schema.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

class RequirementReader {
public:
    RequirementReader(const Requirement& typed, const OutputQuantity& output, std::string path,
                      Problems& problems)
        : typed_(typed), output_(output), path_(std::move(path)), problems_(problems) {}

    void read(OutputRequirement& made) {
        made.guard_factor = typed_.guard_factor;
        made.guard_rule = typed_.guard_rule;
        made.target_risk = typed_.target_risk;
        made.target_uncertainty = interval(&Requirement::target_uncertainty, tell<"target uncertainty">());
        made.lower_limit = value(&Requirement::lower_limit, tell<"lower limit">());
        made.upper_limit = value(&Requirement::upper_limit, tell<"upper limit">());
        made.prior_mean = value(&Requirement::prior_mean, tell<"mean of the prior">());
        made.prior_standard_deviation =
            interval(&Requirement::prior_standard_deviation, tell<"standard deviation of the prior">());
        check(made);
    }

private:
    Message title(const Message& what) const { return tell<"%1 of %2">(what, output_.symbol); }

    template <class M>
    std::string place(M Requirement::*member) const {
        return path_ + requirement_object().place(member);
    }

    using Figure = std::optional<Quantity> Requirement::*;

    /// A width, greater than zero, whose unit may be K or degC where it is of a temperature.
    std::optional<double> interval(Figure figure, const Message& what) {
        const std::optional<Quantity>& typed = typed_.*figure;
        if (!typed) return std::nullopt;
        const Message objection = unit_objection(title(what), *typed, output_.unit);
        if (!objection.empty())
            problems_.error(place(figure), objection);
        else if (!(typed->value > 0))
            problems_.error(place(figure), tell<"the %1 must be greater than zero">(title(what)));
        return typed->unit.interval_to_si(typed->value);
    }

    std::optional<double> value(Figure figure, const Message& what) {
        const std::optional<Quantity>& typed = typed_.*figure;
        if (!typed) return std::nullopt;
        // A temperature has its limits in degC also where it is given in K.
        const Unit scale = is_reading(output_.unit, output_.temperature) ? Unit::of("degC") : output_.unit;
        const Message objection = unit_objection(title(what), *typed, scale);
        if (!objection.empty()) {
            problems_.error(place(figure), objection);
            problems_.items().back().remedies = remedies_as_difference(*typed, scale, place(figure));
        }
        return typed->si();
    }

    void check(const OutputRequirement& made) {
        if (made.lower_limit && made.upper_limit && !(*made.lower_limit < *made.upper_limit))
            problems_.error(place(&Requirement::upper_limit),
                            tell<"the %1 must be above the lower limit">(title(tell<"upper limit">())));
        if (!std::isfinite(made.guard_factor) || std::abs(made.guard_factor) > 10.0)
            problems_.error(place(&Requirement::guard_factor),
                            tell<"the guard factor of %1 must lie between -10 and 10; 1 is a guard band of "
                                 "U, 0 simple acceptance">(output_.symbol));
        check_rule(made);
        if (made.prior_mean.has_value() != made.prior_standard_deviation.has_value())
            problems_.error(
                path_, tell<"the prior of %1 needs both a mean and a standard deviation">(output_.symbol));
        if (made.prior_mean && !made.lower_limit && !made.upper_limit)
            problems_.error(
                path_, tell<"the prior of %1 is of use only with a tolerance: give a limit">(output_.symbol));
    }

    void check_rule(const OutputRequirement& made) {
        const auto refuse = [&](const Message& why) {
            problems_.error(place(&Requirement::guard_rule), why);
        };
        if (is_of_ratio(made.guard_rule) && !(made.lower_limit && made.upper_limit))
            refuse(
                tell<"the guard band of %1 follows from the ratio of tolerance and U: give both limits, or "
                     "choose a guard factor">(output_.symbol));
        if (is_of_prior(made.guard_rule) && !made.prior_mean)
            refuse(
                tell<"the guard band of %1 is made for a global risk: give the prior, or choose a specific "
                     "risk">(output_.symbol));
        if (has_target_risk(made.guard_rule) && !made.lower_limit && !made.upper_limit)
            refuse(tell<"the guard band of %1 needs a tolerance: give a limit">(output_.symbol));
        if (!(made.target_risk > 0.0 && made.target_risk <= 0.5))
            problems_.error(place(&Requirement::target_risk),
                            tell<"the target risk of %1 must lie above 0 and not above 0.5">(output_.symbol));
    }

    const Requirement& typed_;
    const OutputQuantity& output_;
    std::string path_;
    Problems& problems_;
};

const Phrase simple_acceptance{"simple acceptance (w = 0)"}, guard_band{"guard band w = %1"},
    guarded_rejection{"guarded rejection (w = −%1)"}, rss_band{"RSS guard band"},
    rp10_band{"NCSL RP-10 guard band"}, dobbert_band{"managed guard band (Dobbert, 2 % false accepts)"},
    specific_band{"guard band to a specific risk of %1"},
    global_band{"guard band to a global consumer's risk of %1"},
    accepted_band{"guard band to a risk of %1 of what is accepted"};

}  // namespace

std::string decision_rule(double guard_factor, const DocumentLanguage& in) {
    if (guard_factor == 0.0) return in.say(simple_acceptance);
    const double size = std::abs(guard_factor);
    const std::string width =
        size == 1.0 ? "U" : typeset_number(format_trimmed(size, 6), in.numbers()) + " U";
    return in.say(guard_factor > 0.0 ? guard_band : guarded_rejection, {width});
}

std::string decision_rule(const OutputRequirement& requirement, const DocumentLanguage& in) {
    const std::string risk = percent_text(requirement.target_risk, in.numbers());
    switch (requirement.guard_rule) {
        case GuardRule::rss:
            return in.say(rss_band);
        case GuardRule::rp10:
            return in.say(rp10_band);
        case GuardRule::dobbert:
            return in.say(dobbert_band);
        case GuardRule::specific_risk:
            return in.say(specific_band, {risk});
        case GuardRule::global_risk:
            return in.say(global_band, {risk});
        case GuardRule::accepted_risk:
            return in.say(accepted_band, {risk});
        case GuardRule::factor:
            break;
    }
    return decision_rule(requirement.guard_factor, in);
}

std::vector<RequirementResult> judge(const UncertaintyResult& result, const AnalysisEntry& entry) {
    std::vector<OutputQuantity> outputs;
    for (const OutputResult& output : result.outputs) outputs.push_back(output.quantity);
    std::vector<OutputRequirement> readable;
    for (const Requirement& typed : entry.requirements) {
        AnalysisEntry one;
        one.requirements = {typed};
        Problems problems;
        const auto read = read_requirements(one, outputs, problems);
        if (!problems.has_errors()) readable.insert(readable.end(), read.begin(), read.end());
    }
    return judge(result, readable);
}

std::vector<OutputRequirement> read_requirements(const AnalysisEntry& entry,
                                                 const std::vector<OutputQuantity>& outputs,
                                                 Problems& problems) {
    std::vector<OutputRequirement> all;
    for (std::size_t i = 0; i < entry.requirements.size(); ++i) {
        const Requirement& typed = entry.requirements[i];
        const std::string path = analysis_fields().place(&AnalysisEntry::requirements, i);
        const auto output =
            std::find_if(outputs.begin(), outputs.end(), [&](const OutputQuantity& candidate) {
                return candidate.group == typed.group && candidate.symbol == typed.symbol;
            });
        if (output == outputs.end()) {
            const Message where = typed.group.empty() ? Message() : tell<" in %1">(in_quotes(typed.group));
            std::vector<std::string> known;
            for (const OutputQuantity& candidate : outputs) known.push_back(candidate.symbol);
            problems.error(
                path, tell<"the model has no output quantity %1%2%3">(
                          in_quotes(typed.symbol), where, did_you_mean(plain_symbol(typed.symbol), known)));
            continue;
        }
        OutputRequirement made;
        made.output = static_cast<std::size_t>(output - outputs.begin());
        RequirementReader(typed, *output, path, problems).read(made);
        all.push_back(made);
    }
    return all;
}

std::vector<RequirementResult> judge(const UncertaintyResult& result, const Project& project,
                                     const std::string& analysis) {
    const AnalysisEntry* entry = project.find_analysis(analysis);
    return entry ? judge(result, *entry) : std::vector<RequirementResult>();
}

}  // namespace covaria
