// Results of a certificate: result lines, tables of them, a matrix where groups have the same quantities.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/report/certificate_parts.h"
#include "core/report/result_statement.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t most_lines = 6;           // more results of an analysis become a table
constexpr std::size_t least_matrix_groups = 3;  // fewer become a table of lines
constexpr std::size_t matrix_symbols = 3;       // side by side on a page
constexpr std::size_t most_interval_notes = 6;

using Groups = std::vector<std::string>;

std::string k_text(const OutputResult& output, const UncertaintyResult& result) {
    const double nu = stated_degrees_of_freedom(output, result);
    const std::string k = typeset_number(format_decimals(output.coverage_factor, 2));
    return std::isfinite(nu) ? k + " (" + typeset_number(format_degrees_of_freedom(nu)) + ")" : k;
}

bool any_degrees(const UncertaintyResult& result) {
    return std::any_of(result.outputs.begin(), result.outputs.end(), [&](const OutputResult& output) {
        return is_measurand(output) && std::isfinite(stated_degrees_of_freedom(output, result));
    });
}

std::string k_head(const UncertaintyResult& result) {
    return any_degrees(result) ? "k (nu_eff)" : "k";
}

/// As running text sets it: with its subscripts, a Greek letter alone as such.
std::string symbol_in_text(const std::string& symbol) {
    return symbol.find_first_of("_^") == std::string::npos ? symbol_to_unicode(symbol) : symbol;
}

/// "Length of the gauge block (pose 7)", or the symbol alone.
std::string name_of_result(const OutputQuantity& quantity) {
    const std::string name = quantity.name.empty() ? symbol_in_text(quantity.symbol) : quantity.name;
    return quantity.group.empty() ? name : name + " (" + quantity.group + ")";
}

void add_lines(Blocks& blocks, const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    FactsBlock lines;
    for (const std::size_t i : outputs) {
        const OutputResult& output = result.outputs[i];
        lines.facts.emplace_back(name_of_result(output.quantity), symbol_in_text(output.quantity.symbol) +
                                                                      " = " + value_statement(output) + ", " +
                                                                      coverage_statement(output, result));
    }
    blocks.push_back(std::move(lines));
}

/// The same k for all: said once.
bool has_one_k(const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    return std::all_of(outputs.begin(), outputs.end(), [&](std::size_t i) {
        return k_text(result.outputs[i], result) == k_text(result.outputs[outputs.front()], result);
    });
}

/// p of the results of a table, and intervals that y ± U does not say.
void add_coverage_notes(TableBuilder& table, const UncertaintyResult& result,
                        const std::vector<std::size_t>& outputs) {
    double least = 1.0, most = 0.0;
    std::vector<std::string> intervals;
    for (const std::size_t i : outputs) {
        const double p = stated_probability(result.outputs[i], result);
        least = std::min(least, p);
        most = std::max(most, p);
        const std::string interval = skewed_interval(result.outputs[i], result);
        if (!interval.empty())
            intervals.push_back(output_label(result.outputs[i].quantity) + " in " + interval);
    }
    const std::string from = probability_text(least), to = probability_text(most);
    const std::string k =
        has_one_k(result, outputs)
            ? k_head(result) + " = " + k_text(result.outputs[outputs.front()], result) + ", "
            : "";
    table.note(k + "p = " + (from == to ? to : from + " to " + to) + ".");
    if (intervals.empty()) return;
    const std::size_t shown = std::min(intervals.size(), most_interval_notes);
    std::string words = "Coverage intervals that are not symmetric about the estimate: ";
    for (std::size_t i = 0; i < shown; ++i) words += (i ? "; " : "") + intervals[i];
    if (shown < intervals.size()) words += "; and " + std::to_string(intervals.size() - shown) + " others";
    table.note(words + ".");
}

void add_table(Blocks& blocks, const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
               const std::string& id) {
    const bool groups = std::any_of(outputs.begin(), outputs.end(),
                                    [&](std::size_t i) { return !result.outputs[i].quantity.group.empty(); });
    TableBuilder table("certified-" + id, "");
    if (groups) table.text("Group");
    table.text("Quantity", true);
    table.text("Result");
    table.symbol(k_head(result));
    for (const std::size_t i : outputs) {
        const OutputResult& output = result.outputs[i];
        std::vector<TableCell> row;
        if (groups) row.emplace_back(output.quantity.group);
        row.emplace_back(output.quantity.symbol);
        row.emplace_back(value_statement(output));
        row.emplace_back(k_text(output, result));
        table.row(std::move(row));
    }
    add_coverage_notes(table, result, outputs);
    blocks.push_back(table.take());
}

/// Some symbols of the groups side by side, a row a group.
void add_matrix(Blocks& blocks, const UncertaintyResult& result, const Groups& groups,
                const std::vector<std::size_t>& columns, const std::string& id) {
    std::vector<std::size_t> shown;
    for (const std::string& group : groups)
        for (const std::size_t c : columns) shown.push_back(measurands_of(result, group)[c]);
    const bool one_k = has_one_k(result, shown);
    TableBuilder table("certified-" + id, "");
    table.text("Group");
    std::vector<std::pair<int, Unit>> heads;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const OutputQuantity& quantity = result.outputs[shown[c]].quantity;
        heads.emplace_back(table.symbol(quantity.symbol), quantity.unit);
        if (!one_k) table.symbol(k_head(result));
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<TableCell> row = {groups[g]};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const OutputResult& output = result.outputs[shown[g * columns.size() + c]];
            row.emplace_back(value_statement(output, false));
            if (!one_k) row.emplace_back(k_text(output, result));
        }
        table.row(std::move(row));
    }
    add_coverage_notes(table, result, shown);
    TableBlock block = table.take();
    for (const auto& [column, unit] : heads)
        block.table.columns[static_cast<std::size_t>(column)].unit = unit;
    blocks.push_back(std::move(block));
}

/// Symbols of one unit, three at a time.
void add_matrices(Blocks& blocks, const UncertaintyResult& result, const Groups& groups,
                  const std::string& id) {
    const std::vector<std::size_t> outputs = measurands_of(result, groups.front());
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < outputs.size(); ++c) {
        columns.push_back(c);
        const bool last = c + 1 == outputs.size();
        if (!last && columns.size() < matrix_symbols &&
            result.outputs[outputs[c]].quantity.unit == result.outputs[outputs[c + 1]].quantity.unit)
            continue;
        add_matrix(blocks, result, groups, columns, id + "-" + std::to_string(c));
        columns.clear();
    }
}

/// Groups with the same measurands, in order of appearance.
std::vector<Groups> classes_of_groups(const UncertaintyResult& result) {
    std::map<std::string, std::size_t> known;
    std::vector<Groups> classes;
    for (const std::string& group : measurand_groups(result)) {
        std::string symbols;
        for (const std::size_t i : measurands_of(result, group)) {
            const OutputQuantity& quantity = result.outputs[i].quantity;
            symbols += quantity.symbol + "\n" + quantity.unit.text() + "\n";
        }
        const auto [entry, fresh] = known.try_emplace(symbols, classes.size());
        if (fresh) classes.emplace_back();
        classes[entry->second].push_back(group);
    }
    return classes;
}

std::string method_sentence(const UncertaintyResult& result) {
    return result.trials == 0
               ? "The standard uncertainty was determined by the law of propagation of uncertainty in "
                 "accordance with JCGM 100."
               : "The distribution was determined by the propagation of distributions in accordance with "
                 "JCGM "
                 "101.";
}

std::string uncertainty_sentences(const UncertaintyResult& result) {
    switch (expanded_by(result)) {
        case ExpandedBy::fixed_factor:
            return "The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the "
                   "fixed coverage factor k; y ± U has the coverage probability p that is stated with it. " +
                   method_sentence(result);
        case ExpandedBy::interval:
            return "The expanded uncertainty U stated after ± is half the width of the probabilistically "
                   "symmetric coverage interval of the coverage probability p, and k = U/u. " +
                   method_sentence(result);
        case ExpandedBy::degrees_of_freedom:
            break;
    }
    return "The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage "
           "factor k, which for a normal distribution, or for a t distribution of the effective degrees of "
           "freedom nu_eff where they are stated, corresponds to the coverage probability p. " +
           method_sentence(result);
}

}  // namespace

void add_certified_results(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    if (!represents_measurand(result)) {
        blocks.push_back(ParagraphBlock{"No result is stated: what was evaluated " +
                                        std::string(does_not_represent) + "; " +
                                        count_text(result.failed_trials) + " trials have no value."});
        return;
    }
    std::vector<std::size_t> measurands;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i])) measurands.push_back(i);
    if (measurands.size() <= most_lines) {
        add_lines(blocks, result, measurands);
        return;
    }
    std::vector<std::size_t> others;
    const std::string& id = evaluated.analysis->id;
    std::size_t number = 0;
    for (const Groups& groups : classes_of_groups(result)) {
        if (groups.size() >= least_matrix_groups) {
            add_matrices(blocks, result, groups, id + "-" + std::to_string(number++));
            continue;
        }
        for (const std::string& group : groups)
            for (const std::size_t i : measurands_of(result, group)) others.push_back(i);
    }
    if (!others.empty()) add_table(blocks, result, others, id);
}

void add_uncertainty_statement(Blocks& blocks, const UncertaintyResult& result) {
    blocks.push_back(ParagraphBlock{uncertainty_sentences(result)});
}

void add_uncertainty_statement(Blocks& blocks, const std::vector<EvaluatedAnalysis>& analyses) {
    std::vector<std::string> said;
    for (const EvaluatedAnalysis& evaluated : analyses) {
        std::string words = uncertainty_sentences(*evaluated.result);
        if (std::find(said.begin(), said.end(), words) == said.end()) said.push_back(std::move(words));
    }
    for (std::string& words : said) blocks.push_back(ParagraphBlock{std::move(words)});
}

}  // namespace covaria::report_parts
