#include "core/project/option_fields.h"

#include "core/setup/fields.h"

namespace covaria {

namespace {

using O = EvaluationOptions;

const std::vector<Method> always{Method::first_order, Method::monte_carlo, Method::adaptive};
const std::vector<Method> with_trials{Method::monte_carlo, Method::adaptive};
const std::vector<Method> if_adaptive{Method::adaptive};

/// The most trials of a run: more would not end on all machines of a laboratory.
constexpr double most_trials = 1e12;
/// The most trials for each component or contributor: these know u to some 2e-5 of it.
constexpr double most_of_a_comparison = 1e9;

template <class E>
OptionField choice(const char* key, const char* title, const char* help, E O::*member,
                   std::vector<Method> methods, const std::vector<ChoiceOf<E>>& choices) {
    ChosenOption chosen{
        [=](const O& options) { return std::string(detail::key_of(choices, options.*member)); },
        [=](O& options, const std::string& given) { options.*member = detail::choice_of(choices, given); }};
    return {.key = key,
            .title = title,
            .help = help,
            .member = std::move(chosen),
            .methods = std::move(methods),
            .choices = detail::keys_and_titles(choices)};
}

OptionField method_field() {
    return choice("method", "Method",
                  "Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as "
                  "many as the tolerance needs.",
                  &O::method, always,
                  {{Method::first_order, "first-order", "Law of propagation only"},
                   {Method::monte_carlo, "monte-carlo", "Monte Carlo, fixed number of trials"},
                   {Method::adaptive, "adaptive", "Monte Carlo, adaptive"}});
}

OptionField variance_reduction_field() {
    const auto kind = [](VarianceReduction reduction, const char* title) {
        // The key is a literal.
        return ChoiceOf<VarianceReduction>{reduction, key_of(reduction).data(), title};
    };
    return choice(
        "varianceReduction", "Variance reduction",
        "Makes each trial tell more; the gain is measured and stated with the result. Plain trials are "
        "those of JCGM 101.",
        &O::variance_reduction, with_trials,
        {kind(VarianceReduction::none, "None: plain trials"),
         kind(VarianceReduction::control_variate, "Control variate: the linear part"),
         kind(VarianceReduction::sobol, "Sobol points, scrambled")});
}

std::vector<OptionField> common_fields() {
    return {method_field(),
            {"trials",
             "Trials",
             "Of the method monte-carlo.",
             &O::trials,
             {Method::monte_carlo},
             {.low = 2.0, .high = most_trials}},
            {"seed", "Seed", "0 to 18446744073709551615, as text.", SeedOption{&O::seed}, with_trials},
            variance_reduction_field(),
            {"coverageProbability",
             "Coverage probability",
             "Of the expanded uncertainty, of intervals and regions.",
             &O::coverage_probability,
             always,
             {.low = 0.0, .high = 1.0, .low_open = true},
             true},
            {"coverageFactor",
             "Coverage factor",
             "A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or "
             "half of the coverage interval (Monte Carlo).",
             &O::coverage_factor,
             always,
             {.low = 0.0, .low_open = true}},
            {"secondOrder", "Second-order terms",
             "Terms of second order of the law of propagation (JCGM 100 5.1.2).", &O::second_order, always}};
}

std::vector<OptionField> trial_fields() {
    return {{"oneAtATimeTrials",
             "Trials one at a time",
             "Of Monte Carlo with all components but one kept constant, for each component; 0: none.",
             &O::one_at_a_time_trials,
             with_trials,
             {.low = 0.0, .high = most_of_a_comparison},
             false,
             {},
             true},
            {"contributorTrials",
             "Trials by contributor",
             "Of Monte Carlo without each contributor, and of it alone; 0: none.",
             &O::contributor_trials,
             with_trials,
             {.low = 0.0, .high = most_of_a_comparison},
             false,
             {},
             true},
            {"sobolTrials",
             "Trials for Sobol indices",
             "Pairs of trials for Sobol indices; 0: none.",
             &O::sobol_trials,
             with_trials,
             {.low = 0.0, .high = most_of_a_comparison},
             false,
             {},
             true}};
}

std::vector<OptionField> adaptive_fields() {
    return {{"significantDigits",
             "Significant digits",
             "Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).",
             &O::significant_digits,
             always,
             {.low = 1.0, .high = 4.0}},
            {"tolerance",
             "Tolerance",
             "A quantity applies to the outputs of its dimension; a number to every output in its SI unit.",
             &O::tolerance,
             if_adaptive,
             {.low = 0.0, .low_open = true}},
            {"minimumBatches",
             "Least number of batches",
             "Of an adaptive run, before it may stop.",
             &O::minimum_batches,
             if_adaptive,
             {.low = 2.0}},
            {"maximumTrials",
             "Most trials",
             "At which an adaptive run stops in any case.",
             &O::maximum_trials,
             if_adaptive,
             {.low = 2.0, .high = most_trials}}};
}

}  // namespace

const std::vector<OptionField>& option_fields() {
    static const std::vector<OptionField> fields = [] {
        std::vector<OptionField> all = common_fields();
        for (const auto& some : {trial_fields(), adaptive_fields()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return fields;
}

std::optional<double> number_of(const OptionMember& member, const EvaluationOptions& options) {
    return std::visit(
        [&](const auto& bound) -> std::optional<double> {
            if constexpr (std::is_same_v<std::decay_t<decltype(bound)>, SeedOption>)
                return static_cast<double>(options.*bound.member);
            else if constexpr (requires { std::optional<double>(options.*bound); })
                return std::optional<double>(options.*bound);
            else
                return std::nullopt;
        },
        member);
}

void set_number(const OptionMember& member, EvaluationOptions& options, std::optional<double> value) {
    std::visit(
        [&](const auto& bound) {
            using Bound = std::decay_t<decltype(bound)>;
            if constexpr (std::is_same_v<Bound, SeedOption>)
                options.*bound.member = static_cast<std::uint64_t>(value.value_or(0.0));
            else if constexpr (std::is_same_v<Bound, std::optional<double> O::*>)
                options.*bound = value;
            else if constexpr (requires { options.*bound = value.value_or(0.0); } &&
                               !std::is_same_v<Bound, std::optional<Quantity> O::*> &&
                               !std::is_same_v<Bound, bool O::*>)
                options.*bound = static_cast<std::decay_t<decltype(options.*bound)>>(value.value_or(0.0));
        },
        member);
}

}  // namespace covaria
