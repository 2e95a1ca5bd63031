// Requirements: target uncertainties and what it takes to meet them, conformity with tolerances.
#include <algorithm>
#include <cmath>

#include "core/report/number_format.h"
#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_reductions = 12;

using Decision = RequirementResult::Decision;

void add_targets(Blocks& blocks, const AnalysisEntry& entry, const EvaluatedAnalysis& evaluated) {
    TableBuilder table("requirements-" + evaluated.analysis->id, "Target uncertainties");
    table.text("Group");
    table.text("Quantity", true);
    table.text("Unit");
    table.number("U", 2);
    table.number("Target");
    table.text("Verdict");
    bool any = false;
    for (const Requirement& requirement : entry.requirements)
        for (const OutputResult& output : evaluated.result->outputs) {
            const OutputQuantity& quantity = output.quantity;
            if (quantity.group != requirement.group || quantity.symbol != requirement.symbol) continue;
            if (!requirement.target_uncertainty) continue;
            any = true;
            const Quantity& typed = *requirement.target_uncertainty;
            const double target = typed.unit.interval_to_si(typed.value);
            table.row({quantity.group, quantity.symbol, unit_text(quantity.unit),
                       interval_in(quantity.unit, output.expanded_uncertainty),
                       interval_in(quantity.unit, target),
                       std::string(output.expanded_uncertainty <= target ? "met" : "not met")});
        }
    if (any) blocks.push_back(table.take());
}

TableBlock reduction_table(const EvaluatedAnalysis& evaluated, const RequirementResult& requirement) {
    const UncertaintyResult& result = *evaluated.result;
    const OutputQuantity& quantity = result.outputs[requirement.output].quantity;
    TableBuilder table(
        "reductions-" + evaluated.analysis->id + "-" + file_name_part(quantity.symbol + " " + quantity.group),
        "What one component alone must be reduced to for U(" + output_label(quantity) +
            ") to meet its target");
    table.text("Component");
    table.text("Unit");
    table.symbol("u(x_i)", 3);
    table.number("needed", 3);
    table.text("Remark");
    const std::size_t shown = std::min(requirement.reductions.size(), most_reductions);
    for (std::size_t i = 0; i < shown; ++i) {
        const RequirementResult::Reduction& r = requirement.reductions[i];
        const BudgetComponent& c = result.budget.components[r.component];
        table.row({c.name + " (" + c.id + ")", unit_text(c.unit), interval_in(c.unit, r.now),
                   r.needed ? TableCell(interval_in(c.unit, *r.needed)) : TableCell{},
                   std::string(r.needed ? "" : "not enough by itself, even if it vanished")});
    }
    table.note("By the law of propagation with correlations, and with the same coverage factor.");
    return table.take();
}

/// With the digits that U lets mean something, and one more.
std::string limits_text(const RequirementResult& r, const OutputResult& output, double guard) {
    const Unit& unit = output.quantity.unit;
    const auto number = [&](double si) {
        return format_to_match(unit.from_si(si), unit.interval_from_si(output.expanded_uncertainty), 3);
    };
    if (r.lower_limit && r.upper_limit)
        return "[" + number(*r.lower_limit + guard) + ", " + number(*r.upper_limit - guard) + "]";
    return r.lower_limit ? "≥ " + number(*r.lower_limit + guard) : "≤ " + number(*r.upper_limit - guard);
}

std::string percent(double probability) {
    const double in_percent = 100.0 * probability;
    if (in_percent > 0.0 && in_percent < 0.001) return "< 0.001 %";
    if (in_percent < 100.0 && in_percent > 99.999) return "> 99.999 %";
    return value_words(std::round(1000.0 * in_percent) / 1000.0) + " %";
}

void add_conformity(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    TableBuilder table("conformity-" + evaluated.analysis->id, "Conformity with tolerances");
    table.text("Quantity");
    table.text("Unit");
    table.text("Tolerance");
    table.text("Acceptance");
    table.text("Decision");
    table.text("Conforming, normal");
    table.text("Conforming, trials");
    table.symbol("C_m", 3);
    bool any = false;
    Blocks risks;
    for (const RequirementResult& r : result.requirements) {
        if (!r.lower_limit && !r.upper_limit) continue;
        any = true;
        const OutputQuantity& quantity = result.outputs[r.output].quantity;
        table.row({output_label(quantity), unit_text(quantity.unit),
                   limits_text(r, result.outputs[r.output], 0.0),
                   limits_text(r, result.outputs[r.output], r.guard_band),
                   std::string(r.decision == Decision::accept ? "accepted" : "rejected"),
                   percent(r.conformance_normal),
                   r.conformance_monte_carlo ? TableCell(percent(*r.conformance_monte_carlo)) : TableCell{},
                   r.capability_index ? TableCell(*r.capability_index) : TableCell{}});
        const double conforming = r.conformance_monte_carlo.value_or(r.conformance_normal);
        std::string words = output_label(quantity) + ": specific " +
                            (r.decision == Decision::accept ? "consumer's risk " + percent(1.0 - conforming)
                                                            : "producer's risk " + percent(conforming)) +
                            " of this decision";
        if (r.global_risks)
            words += "; global risks of the rule for its prior: consumer's " +
                     percent(r.global_risks->consumer) + ", producer's " + percent(r.global_risks->producer);
        risks.push_back(ParagraphBlock{words + "."});
    }
    if (!any) return;
    table.note(
        "JCGM 106: probability that the measurand lies inside the tolerance, given the result. The "
        "acceptance "
        "interval is the tolerance less guard bands of the guard factor times U (ISO 14253-1).");
    blocks.push_back(table.take());
    blocks.insert(blocks.end(), risks.begin(), risks.end());
}

}  // namespace

void add_requirements(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const AnalysisEntry* entry = source.project.find_analysis(evaluated.analysis->id);
    if (!entry || entry->requirements.empty()) return;
    add_targets(blocks, *entry, evaluated);
    for (const RequirementResult& requirement : evaluated.result->requirements)
        if (!requirement.reductions.empty()) blocks.push_back(reduction_table(evaluated, requirement));
    add_conformity(blocks, evaluated);
}

}  // namespace covaria::report_parts
