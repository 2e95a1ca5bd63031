// Words and selections that the sections of a report share.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "core/base/file_names.h"
#include "core/base/name.h"
#include "core/base/placeholders.h"
#include "core/report/report_parts.h"
#include "core/report/result_columns.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::report_parts {

TableBuilder::TableBuilder(std::string id, const Message& title, const DocumentLanguage& in)
    : in_(in), block_{{std::move(id), in.say(title)}, {{}, 2, in}} {}

Column& TableBuilder::add(const std::string& key, Text head) {
    Column& column = block_.table.add(key.empty() ? std::to_string(block_.table.columns.size()) : key);
    column.title = std::move(head);
    return column;
}

Column& TableBuilder::text(const Message& head, bool symbol_cells) {
    Column& column = add({}, running_text(in_.say(head)));
    column.symbols = symbol_cells;
    return column;
}

Column& TableBuilder::number(const Message& head, const std::string& key) {
    return add(key, running_text(in_.say(head)));
}

Column& TableBuilder::symbol(const std::string& head, const std::string& key) {
    return add(key, symbols_text(head));
}

Column& TableBuilder::fixed(const Message& head, int decimals) {
    const std::string words = in_.say(head);
    return add({}, looks_like_symbol(words) ? symbols_text(words) : running_text(words)).fixed(decimals);
}

void TableBuilder::columns(const Table& table, const std::vector<std::string>& keys) {
    const auto take = [&](const Column& from, bool hidden) {
        const std::vector<std::string> unit{from.unit ? from.unit->display() : ""};
        Column column = from;
        column.cell = {};
        if (!from.head.empty()) {
            const auto words = [&] {
                return fill_placeholders<std::string>(in_.say_declared(from.head), unit);
            };
            column.title = from.is_symbol ? symbols_text(from.head) : running_text(words());
            column.unit.reset();  // the head has it
        }
        if (from.unit) column.rule.form = form_of(table, from, *from.unit, block_.view);
        column.hidden = hidden;
        block_.table.columns.push_back(std::move(column));
    };
    for (const std::string& key : keys) take(table[key], false);
    for (const std::string& key : keys) {
        std::vector<std::string> read = table[key].rule.row;
        read.push_back(table[key].rule.of);
        for (const std::string& other : read)
            if (table.find(other) && !block_.table.find(other)) take(table[other], true);
    }
}

void TableBuilder::row_of(const Table& table, std::size_t row) {
    std::vector<Cell> cells;
    for (const Column& column : block_.table.columns) cells.push_back(table.cell(row, column.key));
    block_.table.row(std::move(cells));
}

void TableBuilder::all_of(const Table& table, const std::vector<std::string>& keys) {
    columns(table, keys);
    for (std::size_t row = 0; row < table.rows; ++row) row_of(table, row);
}

void TableBuilder::row_with(std::map<std::string, Cell> cells) {
    std::vector<Cell> all;
    for (const Column& column : block_.table.columns) all.push_back(std::move(cells[column.key]));
    block_.table.row(std::move(all));
}

void TableBuilder::results(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                           const std::vector<std::string>& keys) {
    const Table all = results_table(result, outputs);
    columns(all, keys);
    std::string group;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const Name& of = result.outputs[outputs[i]].quantity.group;
        if (of != group) subhead(said_name(of));
        group = of;
        row_of(all, i);
    }
}

std::string type_text(EvaluationType type) {
    return type == EvaluationType::type_a ? "A" : "B";
}

std::string unit_text(const Unit& unit) {
    return unit.text() == "1" ? "1" : unit.display();
}

std::string id_part(const std::string& text) {
    std::string out = file_name_part(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

Text output_text(const OutputQuantity& quantity, const DocumentLanguage& in) {
    const Text symbol = symbol_text(quantity.symbol);
    return quantity.group.empty() ? symbol : symbol + (" (" + in.say(said_name(quantity.group)) + ")");
}

Message output_label(const OutputQuantity& quantity) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return quantity.group.empty() ? Message(symbol) : symbol + " (" + said_name(quantity.group) + ")";
}

Measured value_in(const Unit& unit, double si) {
    return {si, Measured::Scale::value, unit};
}

Measured interval_in(const Unit& unit, double si) {
    return {si, Measured::Scale::interval, unit};
}

Message contributor_title(const ContributorResult& result) {
    return result.contributor.empty() ? tell<"the set-up">() : said_name(result.contributor);
}

bool is_measurand(const OutputResult& output) {
    return output.quantity.role == OutputRole::measurand;
}

std::vector<Name> measurand_groups(const UncertaintyResult& result) {
    std::vector<Name> groups;
    for (const OutputResult& output : result.outputs)
        if (is_measurand(output) &&
            std::find(groups.begin(), groups.end(), output.quantity.group) == groups.end())
            groups.push_back(output.quantity.group);
    return groups;
}

std::vector<std::size_t> measurands_of(const UncertaintyResult& result, const std::string& group) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < result.outputs.size(); ++i)
        if (is_measurand(result.outputs[i]) && result.outputs[i].quantity.group == group)
            indices.push_back(i);
    return indices;
}

bool groups_alike(const UncertaintyResult& result, const std::vector<Name>& groups) {
    const auto quantities = [&result](const std::string& group) {
        std::vector<std::pair<std::string, std::string>> list;
        for (const std::size_t i : measurands_of(result, group))
            list.emplace_back(result.outputs[i].quantity.symbol, result.outputs[i].quantity.unit.text());
        return list;
    };
    return std::all_of(groups.begin(), groups.end(), [&](const std::string& group) {
        return quantities(group) == quantities(groups.front());
    });
}

std::vector<Name> groups_like_the_first(const UncertaintyResult& result) {
    std::vector<Name> groups = measurand_groups(result);
    if (groups.empty()) return groups;
    const Name first = groups.front();
    std::erase_if(groups, [&](const Name& group) { return !groups_alike(result, {first, group}); });
    return groups;
}

std::vector<Name> groups_in_full(const UncertaintyResult& result) {
    const std::vector<Name> all = measurand_groups(result);
    if (all.size() <= 2) return all;
    const std::vector<Name> groups = groups_like_the_first(result);
    std::map<std::string, double> sum_of_symbol;
    for (const std::string& group : groups)
        for (const std::size_t i : measurands_of(result, group))
            sum_of_symbol[result.outputs[i].quantity.symbol] += result.outputs[i].expanded_uncertainty;
    const auto weight = [&](const std::string& group) {
        double sum = 0.0;
        for (const std::size_t i : measurands_of(result, group)) {
            const double whole = sum_of_symbol[result.outputs[i].quantity.symbol];
            if (whole > 0.0) sum += result.outputs[i].expanded_uncertainty / whole;
        }
        return sum;
    };
    return {*std::max_element(groups.begin(), groups.end(),
                              [&](const auto& a, const auto& b) { return weight(a) < weight(b); })};
}

}  // namespace covaria::report_parts
