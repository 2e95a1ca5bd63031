// Requirements: target uncertainties and what it takes to meet them, conformity with tolerances.
#include <algorithm>
#include <cmath>

#include "core/base/name.h"
#include "core/project/stated_requirements.h"
#include "core/propagation/reverse_budget.h"
#include "core/report/certificate_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "core/views/result_words.h"

namespace covaria::report_parts {
namespace {

using Decision = RequirementResult::Decision;

namespace words = certificate_words;

using Verdicts = std::vector<RequirementResult>;

/// The number of digits with which no U that exceeds its target is written as the target is.
int digits_of_targets(const Verdicts& verdicts, const EvaluatedAnalysis& evaluated) {
    const int everywhere = evaluated.analysis->style.digits.value_or(2);
    int digits = everywhere;
    for (const RequirementResult& r : verdicts) {
        if (!r.target_uncertainty || r.meets_target) continue;
        const OutputResult& output = evaluated.result->outputs[r.output];
        const Unit& unit = output.quantity.unit;
        const double U = unit.interval_from_si(output.expanded_uncertainty),
                     target = unit.interval_from_si(*r.target_uncertainty);
        while (digits < most_digits && format_significant(U, digits) == format_significant(target, digits))
            ++digits;
    }
    return digits;
}

void add_targets(Blocks& blocks, const Verdicts& verdicts, const EvaluatedAnalysis& evaluated,
                 const DocumentLanguage& in) {
    TableBuilder table("requirements-" + evaluated.analysis->id, tell<"Target uncertainties">(), in);
    table.text(tell<"Group">());
    table.text(tell<"Quantity">(), true);
    table.text(tell<"Unit">());
    table.number("U").uncertainty(digits_of_targets(verdicts, evaluated));
    table.number(tell<"Target">()).typed();
    table.text(tell<"Verdict">());
    bool any = false;
    for (const RequirementResult& r : verdicts) {
        if (!r.target_uncertainty) continue;
        any = true;
        const OutputResult& output = evaluated.result->outputs[r.output];
        const OutputQuantity& quantity = output.quantity;
        table.row({in.say(said_name(quantity.group)), quantity.symbol, quantity.unit,
                   interval_in(quantity.unit, output.expanded_uncertainty),
                   interval_in(quantity.unit, *r.target_uncertainty),
                   in.say(!r.not_judged.empty() ? tell<"not judged">()
                          : r.meets_target      ? tell<"met">()
                                                : tell<"not met">())});
    }
    if (any) blocks.push_back(table.take());
}

Message reduction_words(const ReverseBudget& budget, const DocumentLanguage& in) {
    Message words =
        budget.trials == 0
            ? tell<
                  "With the figure put in, U by the law of propagation is the target; k follows the "
                  "effective degrees of freedom.">()
            : tell<
                  "With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same "
                  "draws.">(count_text(budget.trials, in.numbers()));
    if (budget.common_factor)
        words += " " + tell<"No component suffices alone: all standard uncertainties multiplied by %1 do.">(
                           grouped_digits(format_significant(rounded_down(*budget.common_factor, 3), 3),
                                          in.numbers()));
    return words;
}

Message remark_on(const ReverseBudget::Reduction& reduction) {
    if (!reduction.needed) return tell<"not enough by itself, even if it vanished">();
    if (reduction.rises_again)
        return tell<"if it vanished, U would exceed the target again, with fewer degrees of freedom">();
    return {};
}

constexpr int digits_of_reductions = 3;

/// The needed uncertainty rounded down, so that it suffices as it is printed.
Quantity sufficient(const Measured& needed) {
    const Quantity exact = needed.in({});
    return {rounded_down(exact.value, digits_of_reductions), exact.unit};
}

void add_reductions(Blocks& blocks, const RequirementResult& r, const EvaluatedAnalysis& evaluated,
                    const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    const auto budget =
        reverse_budget(evaluated.analysis->model.get(), result, r.output, *r.target_uncertainty);
    if (!budget || budget->reductions.empty()) return;
    const OutputQuantity& quantity = result.outputs[r.output].quantity;
    TableBuilder table(
        "reductions-" + evaluated.analysis->id + "-" + id_part(quantity.symbol + " " + quantity.group),
        tell<"What one component alone must be reduced to for U(%1) to meet its target">(
            output_label(quantity)),
        in);
    table.text(tell<"Component">());
    table.text(tell<"Unit">());
    table.symbol("u(x_i)").figure(digits_of_reductions);
    table.number(tell<"needed">()).figure(digits_of_reductions);
    table.text(tell<"Remark">());
    for (const ReverseBudget::Reduction& reduction : budget->reductions) {
        const BudgetComponent& c = result.budget.components[reduction.component];
        table.row({in.say(tell<"%1 (%2)">(c.name, c.id)), c.unit, interval_in(c.unit, reduction.now),
                   reduction.needed ? Cell(sufficient(interval_in(c.unit, *reduction.needed))) : Cell{},
                   in.say(remark_on(reduction))});
    }
    table.note(reduction_words(*budget, in));
    blocks.push_back(table.take());
}

/// The limits of acceptance, with the digits that U lets mean something, and one more.
std::string limits_text(const RequirementResult& r, const OutputResult& output, double guard,
                        const NumberLocale& locale) {
    const Unit& unit = output.quantity.unit;
    const auto number = [&](double si) {
        return grouped_digits(
            format_to_match(unit.from_si(si), unit.interval_from_si(output.expanded_uncertainty), 3), locale);
    };
    const bool nothing_left = guard == infinity || (r.lower_limit && r.upper_limit &&
                                                    *r.lower_limit + guard > *r.upper_limit - guard);
    if (nothing_left) return "∅";
    if (r.lower_limit && r.upper_limit)
        return "[" + number(*r.lower_limit + guard) + (locale.decimal == "," ? "; " : ", ") +
               number(*r.upper_limit - guard) + "]";
    return r.lower_limit ? "≥ " + number(*r.lower_limit + guard) : "≤ " + number(*r.upper_limit - guard);
}

std::string by_words(RequirementResult::Distribution by, const DocumentLanguage& in) {
    using enum RequirementResult::Distribution;
    return in.say(by == student_t ? words::student_t : by == trials ? words::trials : words::normal);
}

std::string decision_words(const RequirementResult& r, const DocumentLanguage& in) {
    if (!r.not_judged.empty()) return in.say(words::not_judged);
    return in.say(r.decision == Decision::accept ? words::passes : words::fails);
}

/// The sentence on the risks of a decision that was taken.
Message risks_of(const RequirementResult& r, const OutputQuantity& quantity, const DocumentLanguage& in) {
    const auto text = [&in](double probability) { return probability_text(probability, in.numbers()); };
    const Message symbol = output_label(quantity);
    const bool accepted = r.decision == Decision::accept;
    const std::string risk = text(accepted ? 1.0 - r.conformance : r.conformance);
    if (!r.global_risks)
        return accepted ? tell<"%1: specific consumer's risk %2 of this decision.">(symbol, risk)
                        : tell<"%1: specific producer's risk %2 of this decision.">(symbol, risk);
    const std::string consumer = text(r.global_risks->consumer), producer = text(r.global_risks->producer);
    return accepted
               ? tell<
                     "%1: specific consumer's risk %2 of this decision; global risks of the rule for its "
                     "prior: consumer's %3, producer's %4.">(symbol, risk, consumer, producer)
               : tell<
                     "%1: specific producer's risk %2 of this decision; global risks of the rule for its "
                     "prior: consumer's %3, producer's %4.">(symbol, risk, consumer, producer);
}

/// The sentence on the risks of items that the rule accepts, or rejects (JCGM 106 9.5).
Message conditional_risks_of(const RequirementResult& r, const OutputQuantity& quantity,
                             const DocumentLanguage& in) {
    const auto text = [&in](double probability) { return probability_text(probability, in.numbers()); };
    return tell<"%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.">(
        output_label(quantity), text(r.global_risks->consumer_if_accepted),
        text(r.global_risks->producer_if_rejected));
}

bool has_tolerance(const RequirementResult& r) {
    return r.lower_limit || r.upper_limit;
}

void add_conformity_row(TableBuilder& table, const RequirementResult& r, const OutputResult& output,
                        const DocumentLanguage& in) {
    const bool judged = r.not_judged.empty();
    const OutputQuantity& quantity = output.quantity;
    const auto number = [](const std::optional<double>& x) { return x ? Cell(*x) : Cell{}; };
    table.row({in.say(output_label(quantity)), quantity.unit, limits_text(r, output, 0.0, in.numbers()),
               judged ? limits_text(r, output, r.guard_band, in.numbers()) : "",
               judged ? decision_rule(r, in) : "", decision_words(r, in),
               judged ? probability_text(r.conformance, in.numbers()) : "",
               judged ? by_words(r.conformance_by, in) : "", number(r.uncertainty_ratio),
               number(r.capability_index)});
}

/// The table of conformity; nothing without tolerances.
std::optional<TableBlock> conformity_table(const Verdicts& verdicts, const EvaluatedAnalysis& evaluated,
                                           const Message& title, const DocumentLanguage& in) {
    if (std::none_of(verdicts.begin(), verdicts.end(), has_tolerance)) return std::nullopt;
    TableBuilder table("conformity-" + evaluated.analysis->id, title, in);
    for (const Phrase* head : {&words::quantity, &words::unit, &words::tolerance, &words::acceptance,
                               &words::rule, &words::decision, &words::conforming, &words::by})
        table.text(in.say(*head));
    table.number("TUR").figure(3);
    table.symbol("C_m").figure(3);
    for (const RequirementResult& r : verdicts)
        if (has_tolerance(r)) add_conformity_row(table, r, evaluated.result->outputs[r.output], in);
    table.note(in.say(words::conformity_note));
    return table.take();
}

void add_conformity(Blocks& blocks, const Verdicts& verdicts, const EvaluatedAnalysis& evaluated,
                    const DocumentLanguage& in) {
    auto table = conformity_table(verdicts, evaluated, tell<"Conformity with tolerances">(), in);
    if (!table) return;
    blocks.push_back(std::move(*table));
    for (const RequirementResult& r : verdicts) {
        if (!has_tolerance(r) || !r.not_judged.empty()) continue;
        const OutputQuantity& quantity = evaluated.result->outputs[r.output].quantity;
        blocks.push_back(ParagraphBlock{in.say(risks_of(r, quantity, in))});
        if (r.global_risks) blocks.push_back(ParagraphBlock{in.say(conditional_risks_of(r, quantity, in))});
    }
}

}  // namespace

void add_certified_conformity(Blocks& blocks, const ReportSource& source,
                              const std::vector<EvaluatedAnalysis>& analyses, const DocumentLanguage& in) {
    for (const EvaluatedAnalysis& evaluated : analyses) {
        const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id);
        if (!entry) continue;
        const std::string title = analyses.size() > 1 ? evaluated.analysis->name : "";
        Verdicts verdicts = judge(*evaluated.result, *entry);
        // A result that may not be stated has no statement of conformity either.
        std::erase_if(verdicts, [&](const RequirementResult& verdict) {
            return !result_words::is_measurand(evaluated.result->outputs[verdict.output]);
        });
        auto table = conformity_table(verdicts, evaluated, title, in);
        if (!table) continue;
        blocks.push_back(std::move(*table));
    }
}

void add_requirements(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id);
    if (!entry || entry->requirements.empty()) return;
    const DocumentLanguage& in = source.in;
    const Verdicts verdicts = judge(*evaluated.result, *entry);
    add_targets(blocks, verdicts, evaluated, in);
    for (const RequirementResult& r : verdicts)
        if (!r.meets_target && r.not_judged.empty()) add_reductions(blocks, r, evaluated, in);
    add_conformity(blocks, verdicts, evaluated, in);
    if (!verdicts.empty() && !verdicts.front().not_judged.empty())
        blocks.push_back(ParagraphBlock{
            in.say(tell<"The requirements are not judged: %1.">(verdicts.front().not_judged))});
}

}  // namespace covaria::report_parts
