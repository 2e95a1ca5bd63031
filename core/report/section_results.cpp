// Results: y, u, nu_eff, k, U and coverage intervals; the matrix of U over groups.
#include <algorithm>
#include <cmath>

#include "core/report/report_parts.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/result_columns.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_group_columns = 13;

TableBlock groups_as_columns(const UncertaintyResult& result, const std::vector<Name>& groups,
                             const Message& title, const DocumentLanguage& in) {
    TableBuilder table("summary", title, in);
    table.text(tell<"U of">(), true);
    table.text(tell<"Unit">());
    for (const Name& group : groups) table.number(group).uncertainty();
    const std::vector<std::size_t> first = measurands_of(result, groups.front());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const OutputQuantity& quantity = result.outputs[first[i]].quantity;
        std::vector<Cell> row = {quantity.symbol, quantity.unit};
        for (const Name& group : groups) {
            const OutputResult& output = result.outputs[measurands_of(result, group)[i]];
            row.emplace_back(interval_in(quantity.unit, output.expanded_uncertainty));
        }
        table.row(std::move(row));
    }
    return table.take();
}

TableBlock groups_as_rows(const UncertaintyResult& result, const std::vector<Name>& groups,
                          const Message& title, const DocumentLanguage& in) {
    TableBuilder table("summary", title, in);
    table.text(tell<"Group">());
    for (const std::size_t i : measurands_of(result, groups.front())) {
        const OutputQuantity& quantity = result.outputs[i].quantity;
        table.symbol("U(" + quantity.symbol + ")").uncertainty().in(quantity.unit);
    }
    for (const Name& group : groups) {
        std::vector<Cell> row = {group};
        for (const std::size_t i : measurands_of(result, group))
            row.emplace_back(
                interval_in(result.outputs[i].quantity.unit, result.outputs[i].expanded_uncertainty));
        table.row(std::move(row));
    }
    return table.take();
}

void add_run_words(Blocks& blocks, const UncertaintyResult& result, const DocumentLanguage& in) {
    const NumberLocale& numbers = in.numbers();
    std::string words =
        in.say(tell<"Coverage probability %1.">(percent_text(result.coverage_probability, numbers))) + " " +
        in.say(expanded_words(result)) + " ";
    if (result.trials == 0) {
        words += in.say(tell<"Values from the law of propagation of uncertainty (JCGM 100).">());
    } else {
        words += in.say(
            tell<"Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is "
                 "probabilistically symmetric, the shortest one beside it. The effective degrees of freedom "
                 "are those of the law of propagation.">(count_text(result.trials, numbers)));
        if (leaves_out_degrees_of_freedom(result))
            words += " " + in.say(tell<"Components with finite degrees of freedom are drawn from normal "
                                       "distributions, as was chosen: U and k leave these degrees of freedom "
                                       "out, unlike k of the law of propagation (JCGM 100 G.6.4).">());
        if (!represents_measurand(result))
            words += " " + in.say(tell<"This result does not represent the measurand: %1 trials, more than "
                                       "1 %, have no value.">(count_text(result.failed_trials, numbers)));
    }
    blocks.push_back(ParagraphBlock{words});
}

/// Adds the second-order uncertainties; nothing where they were not asked for.
void add_second_order(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (result.outputs[i].first_order.second_order_standard_uncertainty) outputs.push_back(i);
    if (outputs.empty()) return;
    TableBuilder table("second-order-" + evaluated.analysis->id,
                       tell<"Law of propagation with second-order terms">(), in);
    table.results(result, outputs,
                  {"symbol", "unit", "u first order", "u second order", "shift second order"});
    table.note(tell<"JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The "
                    "shift, half the sum of the second derivatives times the variances, is what the mean of "
                    "the measurand differs by from the value at the estimates; neither is part of the "
                    "results above.">());
    blocks.push_back(table.take());
}

}  // namespace

TableBlock results_block(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                         const Message& title, const DocumentLanguage& in, bool explained) {
    const bool intervals = std::all_of(outputs.begin(), outputs.end(), [&](std::size_t i) {
        return result.outputs[i].monte_carlo.has_value();
    });
    std::vector<std::string> keys = {"symbol", "unit", "estimate", "u", "nu_eff", "k", "U"};
    if (intervals && !explained) std::erase(keys, "nu_eff");
    if (intervals)
        keys.insert(keys.end(), {"interval low", "interval high", "shortest low", "shortest high"});
    TableBuilder table("results", title, in);
    table.results(result, outputs, keys);
    return table.take();
}

std::optional<TableBlock> summary_matrix(const UncertaintyResult& result, const Message& title,
                                         const DocumentLanguage& in) {
    const std::vector<Name> groups = measurand_groups(result);
    if (groups.size() < 3 || !groups_alike(result, groups)) return std::nullopt;
    return groups.size() <= most_group_columns ? groups_as_columns(result, groups, title, in)
                                               : groups_as_rows(result, groups, title, in);
}

void add_results(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    const DocumentLanguage& in = source.in;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Results">())});
    add_run_words(blocks, result, in);
    std::vector<std::size_t> measurands, others;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        (is_measurand(result.outputs[i]) ? measurands : others).push_back(i);
    TableBlock block = results_block(result, measurands, tell<"Measurands">(), in);
    block.table.id = "results-" + evaluated.analysis->id;
    blocks.push_back(std::move(block));
    if (!others.empty()) {
        TableBlock intermediate = results_block(result, others, tell<"Intermediate quantities">(), in);
        intermediate.table.id = "intermediate-" + evaluated.analysis->id;
        blocks.push_back(std::move(intermediate));
    }
    add_second_order(blocks, evaluated, in);
    add_requirements(blocks, source, evaluated);
}

}  // namespace covaria::report_parts
