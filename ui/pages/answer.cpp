#include "ui/pages/answer.h"

#include <algorithm>
#include <cmath>

#include "core/propagation/requirements.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/result_statement.h"
#include "ui/models/sheet_figures.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const char* const em_space = "\u2003";  // an em, between two answers

bool is_larger(const OutputResult& a, const OutputResult& b) {
    return a.expanded_uncertainty > b.expanded_uncertainty ||
           (std::isnan(a.expanded_uncertainty) && !std::isnan(b.expanded_uncertainty));
}

/// The output with the largest U of each dimension, in order of the dimensions.
std::vector<std::size_t> worst_of_each_kind(const UncertaintyResult& result,
                                            const std::vector<std::size_t>& outputs) {
    std::vector<std::size_t> worst;
    for (const std::size_t output : outputs) {
        const OutputResult& now = result.outputs[output];
        const auto same = std::ranges::find_if(worst, [&](std::size_t other) {
            return result.outputs[other].quantity.unit.dimension() == now.quantity.unit.dimension();
        });
        if (same == worst.end())
            worst.push_back(output);
        else if (is_larger(now, result.outputs[*same]))
            *same = output;
    }
    return worst;
}

Text uncertainty_words(const OutputResult& output, const DocumentLanguage& in, const DisplayUnits& units,
                       int digits) {
    const Unit& unit = units.of(output.quantity.unit);
    const double U = unit.interval_from_si(output.expanded_uncertainty);
    const std::string number =
        std::isfinite(U) ? grouped_digits(format_decimals(U, decimals_for(U, digits)), in.numbers()) : "∞";
    return symbol_text("U") + (" = " + number + unit_after_number(unit) + " (") +
           symbol_text(output.quantity.symbol) + ")";
}

Text coverage_words(const OutputResult& output, const UncertaintyResult& result, const DocumentLanguage& in) {
    Text words;
    if (std::isfinite(output.coverage_factor))
        words +=
            symbol_text("k") +
            (" = " + grouped_digits(format_decimals(output.coverage_factor, 2), in.numbers()) + em_space);
    return words + symbol_text("p") + (" = " + probability_text(stated_probability(output, result), in));
}

}  // namespace

Answer answer_of(const UncertaintyResult& result, std::size_t output, const DocumentLanguage& in,
                 const DisplayUnits& units, int digits) {
    Answer answer;
    const OutputResult& looked_at = result.outputs[output];
    const Name& group = looked_at.quantity.group;
    for (std::size_t j = 0; j < result.outputs.size(); ++j) {
        const OutputQuantity& quantity = result.outputs[j].quantity;
        const bool belongs =
            group.empty() ? j == output : quantity.group == group && quantity.role == OutputRole::measurand;
        if (belongs) answer.outputs.push_back(j);
    }
    if (answer.outputs.empty()) answer.outputs.push_back(output);
    for (const std::size_t j : answer.outputs)
        answer.statements += symbol_to_unicode(result.outputs[j].quantity.symbol) + " = " +
                             result_statement(result.outputs[j], result, in, units, digits) + "\n";
    if (answer.outputs.size() == 1) {
        const OutputResult& only = result.outputs[answer.outputs.front()];
        answer.value = symbol_text(only.quantity.symbol);
        // The only one of a point: which point nothing else beside it says.
        if (!group.empty()) answer.value += " (" + in.say(said_name(group)) + ")";
        answer.value += " = ";
        if (is_stated_by_interval(only, result)) {
            answer.value += result_statement(only, result, in, units, digits);
            return answer;
        }
        answer.value += value_statement(only, true, in, units, digits);
        if (only.expanded_uncertainty != 0.0) answer.coverage = coverage_words(only, result, in);
        return answer;
    }
    const std::vector<std::size_t> worst = worst_of_each_kind(result, answer.outputs);
    for (const std::size_t j : worst) {
        if (!answer.value.empty()) answer.value += em_space;
        answer.value += uncertainty_words(result.outputs[j], in, units, digits);
    }
    answer.coverage = coverage_words(result.outputs[worst.front()], result, in);
    return answer;
}

/// "U 61 ≤ 70 nm": the target as it was typed, U with two digits, or as many as tell them apart.
Text target_words(const OutputResult& output, double target, bool met, const DocumentLanguage& in,
                  const DisplayUnits& units) {
    constexpr int digits_of_target = 6;
    const Unit unit = readable_unit(target, units.of(output.quantity.unit)).interval();
    const double U = unit.interval_from_si(output.expanded_uncertainty), most = unit.interval_from_si(target);
    if (!std::isfinite(U) || !(most > 0.0)) return {};
    const std::string limit = to_std(QString::number(most, 'g', digits_of_target));
    const auto is_told_apart = [&](const std::string& shown) {
        return U == most ||
               QString::fromStdString(shown).toDouble() != QString::fromStdString(limit).toDouble();
    };
    int digits = 2;
    while (digits < digits_of_target && !is_told_apart(format_decimals(U, decimals_for(U, digits)))) ++digits;
    const std::string shown = format_decimals(U, decimals_for(U, digits));
    return symbol_text("U") + (" " + grouped_digits(shown, in.numbers()) + (met ? " ≤ " : " > ") +
                               grouped_digits(limit, in.numbers()) + unit_after_number(unit));
}

VerdictWords verdict_words(const UncertaintyResult& result, const Answer& answer,
                           const std::vector<RequirementResult>& verdicts, const DocumentLanguage& in,
                           const DisplayUnits& units) {
    VerdictWords all;
    Text not_met;
    std::size_t judged = 0;
    const RequirementResult* only = nullptr;
    for (const RequirementResult& verdict : verdicts) {
        if (!std::ranges::count(answer.outputs, verdict.output)) continue;
        ++judged;
        only = &verdict;
        if (is_met(verdict)) continue;
        if (!not_met.empty()) not_met += ", ";
        not_met += symbol_text(result.outputs[verdict.output].quantity.symbol);
    }
    if (judged == 0) return all;
    all.met = not_met.empty();
    all.words = all.met ? Text(to_std(tr("met"))) : Text(to_std(tr("not met")));
    if (!all.met && answer.outputs.size() > 1) all.words += ": " + not_met;
    if (answer.outputs.size() == 1 && judged == 1 && only->target_uncertainty && !only->lower_limit &&
        !only->upper_limit && only->not_judged.empty())
        all.detail =
            target_words(result.outputs[only->output], *only->target_uncertainty, all.met, in, units);
    return all;
}

VerdictWords decision_words(const std::vector<DecidedRow>& decisions) {
    const auto all = static_cast<int>(decisions.size());
    const auto failed = static_cast<int>(count_of(decisions, TestVerdict::Is::not_met));
    const auto open = static_cast<int>(count_of(decisions, TestVerdict::Is::open));
    VerdictWords words{failed == 0 && open == 0, failed == 0 && open > 0, {}, {}};
    if (failed > 0)
        words.words = to_std(tr("not met: %1 of %2").arg(failed).arg(all));
    else if (open > 0)
        words.words = to_std(tr("not decided: %1 of %2").arg(open).arg(all));
    else if (all > 0)
        words.words = to_std(all == 1 ? tr("met") : tr("all %1 met").arg(all));
    return words;
}

}  // namespace covaria::ui
