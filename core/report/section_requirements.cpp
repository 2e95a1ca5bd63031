// Requirements: target uncertainties and what it takes to meet them, conformity with tolerances.
#include <algorithm>
#include <cmath>

#include "core/project/stated_requirements.h"
#include "core/propagation/reverse_budget.h"
#include "core/report/certificate_parts.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"

namespace covaria::report_parts {
namespace {

using Decision = RequirementResult::Decision;

namespace words = certificate_words;

using Verdicts = std::vector<RequirementResult>;

void add_targets(Blocks& blocks, const Verdicts& verdicts, const EvaluatedAnalysis& evaluated) {
    TableBuilder table("requirements-" + evaluated.analysis->id, "Target uncertainties");
    table.text("Group");
    table.text("Quantity", true);
    table.text("Unit");
    table.number("U", 2);
    table.number("Target");
    table.text("Verdict");
    bool any = false;
    for (const RequirementResult& r : verdicts) {
        if (!r.target_uncertainty) continue;
        any = true;
        const OutputResult& output = evaluated.result->outputs[r.output];
        const OutputQuantity& quantity = output.quantity;
        table.row({quantity.group, quantity.symbol, unit_text(quantity.unit),
                   interval_in(quantity.unit, output.expanded_uncertainty),
                   interval_in(quantity.unit, *r.target_uncertainty),
                   std::string(!r.not_judged.empty() ? "not judged"
                               : r.meets_target      ? "met"
                                                     : "not met")});
    }
    if (any) blocks.push_back(table.take());
}

std::string reduction_words(const ReverseBudget& budget) {
    std::string words =
        budget.trials == 0
            ? "With the figure put in, U by the law of propagation is the target; k follows the "
              "effective degrees of freedom."
            : "With the figure put in, U by Monte Carlo is the target; found with " +
                  count_text(budget.trials) + " trials of the same draws.";
    if (budget.common_factor)
        words += " No component suffices alone: all standard uncertainties multiplied by " +
                 format_significant(*budget.common_factor, 3) + " do.";
    return words;
}

void add_reductions(Blocks& blocks, const RequirementResult& r, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    const auto budget =
        reverse_budget(evaluated.analysis->model.get(), result, r.output, *r.target_uncertainty);
    if (!budget || budget->reductions.empty()) return;
    const OutputQuantity& quantity = result.outputs[r.output].quantity;
    TableBuilder table(
        "reductions-" + evaluated.analysis->id + "-" + id_part(quantity.symbol + " " + quantity.group),
        "What one component alone must be reduced to for U(" + output_label(quantity) +
            ") to meet its target");
    table.text("Component");
    table.text("Unit");
    table.symbol("u(x_i)", 3);
    table.number("needed", 3);
    table.text("Remark");
    for (const ReverseBudget::Reduction& reduction : budget->reductions) {
        const BudgetComponent& c = result.budget.components[reduction.component];
        table.row({c.name + " (" + c.id + ")", unit_text(c.unit), interval_in(c.unit, reduction.now),
                   reduction.needed ? TableCell(interval_in(c.unit, *reduction.needed)) : TableCell{},
                   std::string(reduction.needed ? "" : "not enough by itself, even if it vanished")});
    }
    table.note(reduction_words(*budget));
    blocks.push_back(table.take());
}

/// With the digits that U lets mean something, and one more.
std::string limits_text(const RequirementResult& r, const OutputResult& output, double guard,
                        const NumberLocale& locale) {
    const Unit& unit = output.quantity.unit;
    const auto number = [&](double si) {
        return grouped_digits(
            format_to_match(unit.from_si(si), unit.interval_from_si(output.expanded_uncertainty), 3), locale);
    };
    if (r.lower_limit && r.upper_limit)
        return "[" + number(*r.lower_limit + guard) + (locale.decimal == "," ? "; " : ", ") +
               number(*r.upper_limit - guard) + "]";
    return r.lower_limit ? "≥ " + number(*r.lower_limit + guard) : "≤ " + number(*r.upper_limit - guard);
}

std::string by_words(RequirementResult::Distribution by, const DocumentLanguage& in) {
    using enum RequirementResult::Distribution;
    return in.say(by == student_t ? words::student_t : by == trials ? words::trials : words::normal);
}

std::string percent(double probability, const NumberLocale& locale = {}) {
    const double in_percent = 100.0 * probability;
    if (in_percent > 0.0 && in_percent < 0.001) return "< 0" + locale.decimal + "001 %";
    if (in_percent < 100.0 && in_percent > 99.999) return "> 99" + locale.decimal + "999 %";
    return typeset_number(format_trimmed(std::round(1000.0 * in_percent) / 1000.0, 6), locale) + " %";
}

std::string decision_words(const RequirementResult& r, const DocumentLanguage& in) {
    if (!r.not_judged.empty()) return in.say(words::not_judged);
    return in.say(r.decision == Decision::accept ? words::accepted : words::rejected);
}

/// Of a decision that was taken.
ParagraphBlock risks_of(const RequirementResult& r, const OutputQuantity& quantity) {
    std::string words = output_label(quantity) + ": specific " +
                        (r.decision == Decision::accept ? "consumer's risk " + percent(1.0 - r.conformance)
                                                        : "producer's risk " + percent(r.conformance)) +
                        " of this decision";
    if (r.global_risks)
        words += "; global risks of the rule for its prior: consumer's " + percent(r.global_risks->consumer) +
                 ", producer's " + percent(r.global_risks->producer);
    return ParagraphBlock{words + "."};
}

bool has_tolerance(const RequirementResult& r) {
    return r.lower_limit || r.upper_limit;
}

void add_conformity_row(TableBuilder& table, const RequirementResult& r, const OutputResult& output,
                        const DocumentLanguage& in) {
    const bool judged = r.not_judged.empty();
    const OutputQuantity& quantity = output.quantity;
    const auto number = [](const std::optional<double>& x) { return x ? TableCell(*x) : TableCell{}; };
    table.row({output_label(quantity), unit_text(quantity.unit), limits_text(r, output, 0.0, in.numbers()),
               judged ? limits_text(r, output, r.guard_band, in.numbers()) : "",
               judged ? decision_rule(r.guard_factor, in) : "", decision_words(r, in),
               judged ? percent(r.conformance, in.numbers()) : "",
               judged ? by_words(r.conformance_by, in) : "", number(r.uncertainty_ratio),
               number(r.capability_index)});
}

/// Nothing without tolerances.
std::optional<TableBlock> conformity_table(const Verdicts& verdicts, const EvaluatedAnalysis& evaluated,
                                           const DocumentLanguage& in) {
    if (std::none_of(verdicts.begin(), verdicts.end(), has_tolerance)) return std::nullopt;
    TableBuilder table("conformity-" + evaluated.analysis->id, "Conformity with tolerances");
    for (const Phrase* head : {&words::quantity, &words::unit, &words::tolerance, &words::acceptance,
                               &words::rule, &words::decision, &words::conforming, &words::by})
        table.text(in.say(*head));
    table.number("TUR", 3);
    table.symbol("C_m", 3);
    for (const RequirementResult& r : verdicts)
        if (has_tolerance(r)) add_conformity_row(table, r, evaluated.result->outputs[r.output], in);
    table.note(in.say(words::conformity_note));
    TableBlock made = table.take();
    made.locale = in.numbers();
    return made;
}

void add_conformity(Blocks& blocks, const Verdicts& verdicts, const EvaluatedAnalysis& evaluated) {
    auto table = conformity_table(verdicts, evaluated, {});
    if (!table) return;
    blocks.push_back(std::move(*table));
    for (const RequirementResult& r : verdicts)
        if (has_tolerance(r) && r.not_judged.empty())
            blocks.push_back(risks_of(r, evaluated.result->outputs[r.output].quantity));
}

}  // namespace

void add_certified_conformity(Blocks& blocks, const ReportSource& source,
                              const std::vector<EvaluatedAnalysis>& analyses, const DocumentLanguage& in) {
    bool headed = false;
    for (const EvaluatedAnalysis& evaluated : analyses) {
        const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id);
        if (!entry) continue;
        auto table = conformity_table(judge(*evaluated.result, *entry), evaluated, in);
        if (!table) continue;
        if (!headed) blocks.push_back(HeadingBlock{2, in.say(words::conformity)});
        headed = true;
        table->table.title = analyses.size() > 1 ? evaluated.analysis->name : "";
        blocks.push_back(std::move(*table));
    }
}

void add_requirements(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id);
    if (!entry || entry->requirements.empty()) return;
    const Verdicts verdicts = judge(*evaluated.result, *entry);
    add_targets(blocks, verdicts, evaluated);
    for (const RequirementResult& r : verdicts)
        if (!r.meets_target && r.not_judged.empty()) add_reductions(blocks, r, evaluated);
    add_conformity(blocks, verdicts, evaluated);
    if (!verdicts.empty() && !verdicts.front().not_judged.empty())
        blocks.push_back(
            ParagraphBlock{"The requirements are not judged: " + verdicts.front().not_judged + "."});
}

}  // namespace covaria::report_parts
