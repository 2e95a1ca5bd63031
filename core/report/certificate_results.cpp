// Results of a certificate: result lines, tables of them, a matrix where groups have the same quantities.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/name.h"
#include "core/report/certificate_parts.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/result_statement.h"

namespace covaria::report_parts {
namespace {

namespace words = certificate_words;

constexpr std::size_t most_lines = 6;           // more results of an analysis become a table
constexpr std::size_t least_matrix_groups = 3;  // fewer become a table of lines
constexpr std::size_t matrix_symbols = 3;       // side by side on a page
constexpr std::size_t most_interval_notes = 6;

using Groups = std::vector<Name>;

std::string k_text(const OutputResult& output, const UncertaintyResult& result, const DocumentLanguage& in) {
    const double nu = stated_degrees_of_freedom(output, result);
    const std::string k = typeset_number(format_decimals(output.coverage_factor, 2), in.numbers());
    return std::isfinite(nu) ? k + " (" + typeset_number(format_degrees_of_freedom(nu), in.numbers()) + ")"
                             : k;
}

bool any_degrees(const UncertaintyResult& result) {
    return std::any_of(result.outputs.begin(), result.outputs.end(), [&](const OutputResult& output) {
        return is_measurand(output) && std::isfinite(stated_degrees_of_freedom(output, result));
    });
}

std::string k_head(const UncertaintyResult& result) {
    return any_degrees(result) ? "k (nu_eff)" : "k";
}

/// The symbol as running text sets it: with its subscripts, a Greek letter alone as such.
std::string symbol_in_text(const std::string& symbol) {
    return symbol.find_first_of("_^") == std::string::npos ? symbol_to_unicode(symbol) : symbol;
}

/// The name of a result: "Length of the gauge block (pose 7)", or the symbol alone.
std::string name_of_result(const OutputQuantity& quantity, const DocumentLanguage& in) {
    const std::string name = quantity.name.empty() ? symbol_in_text(quantity.symbol) : in.say(quantity.name);
    return quantity.group.empty() ? name : name + " (" + in.say(said_name(quantity.group)) + ")";
}

void add_lines(Blocks& blocks, const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
               const DocumentLanguage& in) {
    FactsBlock lines;
    for (const std::size_t i : outputs) {
        const OutputResult& output = result.outputs[i];
        lines.facts.emplace_back(
            name_of_result(output.quantity, in),
            symbol_in_text(output.quantity.symbol) + " = " + result_statement(output, result, in));
    }
    blocks.push_back(std::move(lines));
}

/// Whether all outputs have the same k, which is then said once.
bool has_one_k(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
               const DocumentLanguage& in) {
    return std::all_of(outputs.begin(), outputs.end(), [&](std::size_t i) {
        return k_text(result.outputs[i], result, in) == k_text(result.outputs[outputs.front()], result, in);
    });
}

/// Adds p of the results of a table, and intervals that y ± U does not say.
void add_coverage_notes(TableBuilder& table, const UncertaintyResult& result,
                        const std::vector<std::size_t>& outputs, const DocumentLanguage& in) {
    double least = 1.0, most = 0.0;
    std::vector<std::string> intervals;
    for (const std::size_t i : outputs) {
        const double p = stated_probability(result.outputs[i], result);
        least = std::min(least, p);
        most = std::max(most, p);
        const std::string interval = skewed_interval(result.outputs[i], result, in);
        if (!interval.empty())
            intervals.push_back(
                in.say(words::in_interval, {in.say(output_label(result.outputs[i].quantity)), interval}));
    }
    const std::string from = probability_text(least, in), to = probability_text(most, in);
    const std::string k =
        has_one_k(result, outputs, in)
            ? k_head(result) + " = " + k_text(result.outputs[outputs.front()], result, in) + ", "
            : "";
    table.note(k + (from == to ? "p = " + to + "." : in.say(words::from_to, {from, to})));
    if (intervals.empty()) return;
    const std::size_t shown = std::min(intervals.size(), most_interval_notes);
    std::string list;
    for (std::size_t i = 0; i < shown; ++i) list += (i ? "; " : "") + intervals[i];
    table.note(shown < intervals.size()
                   ? in.say(words::skewed_intervals_and, {list, std::to_string(intervals.size() - shown)})
                   : in.say(words::skewed_intervals, {list}));
}

void add_table(Blocks& blocks, const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
               const std::string& id, const DocumentLanguage& in) {
    const bool groups = std::any_of(outputs.begin(), outputs.end(),
                                    [&](std::size_t i) { return !result.outputs[i].quantity.group.empty(); });
    TableBuilder table("certified-" + id, "", in);
    if (groups) table.text(in.say(words::group));
    table.text(in.say(words::quantity), true);
    table.text(in.say(words::result));
    table.symbol(k_head(result));
    for (const std::size_t i : outputs) {
        const OutputResult& output = result.outputs[i];
        std::vector<Cell> row;
        if (groups) row.emplace_back(in.say(said_name(output.quantity.group)));
        row.emplace_back(output.quantity.symbol);
        row.emplace_back(value_statement(output, true, in));
        row.emplace_back(k_text(output, result, in));
        table.row(std::move(row));
    }
    add_coverage_notes(table, result, outputs, in);
    blocks.push_back(table.take());
}

/// Adds a matrix of some symbols side by side, with a row for each group.
void add_matrix(Blocks& blocks, const UncertaintyResult& result, const Groups& groups,
                const std::vector<std::size_t>& columns, const std::string& id, const DocumentLanguage& in) {
    std::vector<std::size_t> shown;
    for (const std::string& group : groups)
        for (const std::size_t c : columns) shown.push_back(measurands_of(result, group)[c]);
    const bool one_k = has_one_k(result, shown, in);
    TableBuilder table("certified-" + id, "", in);
    table.text(in.say(words::group));
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const OutputQuantity& quantity = result.outputs[shown[c]].quantity;
        table.symbol(quantity.symbol).in(quantity.unit);
        if (!one_k) table.symbol(k_head(result));
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<Cell> row = {in.say(said_name(groups[g]))};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const OutputResult& output = result.outputs[shown[g * columns.size() + c]];
            row.emplace_back(value_statement(output, false, in));
            if (!one_k) row.emplace_back(k_text(output, result, in));
        }
        table.row(std::move(row));
    }
    add_coverage_notes(table, result, shown, in);
    blocks.push_back(table.take());
}

/// Adds matrices of symbols of one unit, three at a time.
void add_matrices(Blocks& blocks, const UncertaintyResult& result, const Groups& groups,
                  const std::string& id, const DocumentLanguage& in) {
    const std::vector<std::size_t> outputs = measurands_of(result, groups.front());
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < outputs.size(); ++c) {
        columns.push_back(c);
        const bool last = c + 1 == outputs.size();
        if (!last && columns.size() < matrix_symbols &&
            result.outputs[outputs[c]].quantity.unit == result.outputs[outputs[c + 1]].quantity.unit)
            continue;
        add_matrix(blocks, result, groups, columns, id + "-" + std::to_string(c), in);
        columns.clear();
    }
}

/// The classes of groups with the same measurands, in order of appearance.
std::vector<Groups> classes_of_groups(const UncertaintyResult& result) {
    std::map<std::string, std::size_t> known;
    std::vector<Groups> classes;
    for (const Name& group : measurand_groups(result)) {
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

std::string uncertainty_sentences(const UncertaintyResult& result, const DocumentLanguage& in) {
    const Phrase& factor = expanded_by(result) == ExpandedBy::fixed_factor ? words::fixed_factor
                           : expanded_by(result) == ExpandedBy::interval   ? words::half_interval
                                                                           : words::by_degrees_of_freedom;
    return in.say(factor) + " " + in.say(result.trials == 0 ? words::by_law : words::by_distributions);
}

}  // namespace

void add_certified_results(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (!represents_measurand(result)) {
        blocks.push_back(ParagraphBlock{in.say(words::no_result, {count_text(result.failed_trials)})});
        return;
    }
    std::vector<std::size_t> measurands;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i])) measurands.push_back(i);
    if (measurands.size() <= most_lines) {
        add_lines(blocks, result, measurands, in);
        return;
    }
    std::vector<std::size_t> others;
    const std::string& id = evaluated.analysis->id;
    std::size_t number = 0;
    for (const Groups& groups : classes_of_groups(result)) {
        if (groups.size() >= least_matrix_groups) {
            add_matrices(blocks, result, groups, id + "-" + std::to_string(number++), in);
            continue;
        }
        for (const std::string& group : groups)
            for (const std::size_t i : measurands_of(result, group)) others.push_back(i);
    }
    if (!others.empty()) add_table(blocks, result, others, id, in);
}

void add_uncertainty_statement(Blocks& blocks, const std::vector<EvaluatedAnalysis>& analyses,
                               const DocumentLanguage& in) {
    // Each sentence is said with the analyses that it is about, in their order.
    std::vector<std::pair<std::string, std::string>> said;
    for (const EvaluatedAnalysis& evaluated : analyses) {
        const std::string words = uncertainty_sentences(*evaluated.result, in);
        const auto found =
            std::find_if(said.begin(), said.end(), [&](const auto& one) { return one.first == words; });
        if (found == said.end())
            said.emplace_back(words, evaluated.analysis->name);
        else
            found->second += ", " + evaluated.analysis->name;
    }
    for (const auto& [words, names] : said)
        blocks.push_back(
            ParagraphBlock{said.size() > 1 ? in.say(certificate_words::results_of, {names, words}) : words});
}

}  // namespace covaria::report_parts
