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
#include "core/report/table_text.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::report_parts {

TableBuilder::TableBuilder(std::string id, const Message& title, const DocumentLanguage& in) : in_(in) {
    block_.table.id = std::move(id);
    block_.table.title = in.say(title);
    block_.locale = in.numbers();
}

int TableBuilder::add(TableColumn column, ColumnStyle style) {
    block_.table.columns.push_back(std::move(column));
    block_.styles.push_back(style);
    return static_cast<int>(block_.styles.size()) - 1;
}

int TableBuilder::text(const Message& header, bool symbol_cells) {
    return add({in_.say(header), {}, false, 0}, {symbol_cells, false, -1, -1, false});
}

int TableBuilder::number(const Message& header, int digits, int match) {
    return add({in_.say(header), {}, false, digits}, {false, true, match, -1, false});
}

int TableBuilder::symbol(const std::string& header, int digits, int match) {
    return add({header, {}, true, digits}, {false, true, match, -1, false});
}

int TableBuilder::fixed(const Message& header, int decimals) {
    const std::string head = in_.say(header);
    return add({head, {}, looks_like_symbol(head), 0}, {false, true, -1, decimals, false});
}

namespace {
const char* const key_of_spread = "rounding";  // in the table of results

/// Places of those keys that there are.
std::vector<int> columns_of(const std::vector<std::string>& keys, const std::vector<std::string>& some) {
    std::vector<int> columns;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (std::find(some.begin(), some.end(), keys[i]) != some.end())
            columns.push_back(static_cast<int>(i));
    return columns;
}

}  // namespace

void TableBuilder::columns(const Table& table, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        const Column& c = table[key];
        const auto match = std::find(keys.begin(), keys.end(), c.rule.match);
        const std::vector<std::string> unit{c.unit ? unit_text(*c.unit) : ""};
        const std::string head =
            c.is_symbol ? c.head : fill_placeholders<std::string>(in_.say_declared(c.head), unit);
        add({head, {}, c.is_symbol, c.rule.digits},
            {c.symbols, is_numeric(c) && !c.says_unit,
             match == keys.end() ? -1 : static_cast<int>(match - keys.begin()), c.rule.decimals, c.rule.input,
             c.rule.match == key_of_spread, columns_of(keys, c.rule.row)});
    }
}

namespace {

TableCell print_cell(const Column& column, std::size_t row, const DocumentLanguage& in) {
    const Cell cell = column.cell(row);
    if (const auto* text = std::get_if<std::string>(&cell))
        return column.own_words ? in.say_declared(*text) : *text;
    if (const auto* message = std::get_if<Message>(&cell)) return in.say(*message);
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return short_list(*symbols);
    if (const auto* unit = std::get_if<Unit>(&cell)) return unit_text(*unit);
    if (const auto* answer = std::get_if<Answer>(&cell))
        return in.say_declared(answer->is ? answer->yes : answer->no);
    const auto* number = std::get_if<Measured>(&cell);
    if (!number) return {};
    const Quantity shown = number->in({});
    if (column.rule.degrees_of_freedom) return shown_degrees_of_freedom(shown.value);
    if (column.rule.percent) return 100.0 * shown.value;
    return shown.unit == Unit{} ? TableCell(shown.value) : TableCell(shown);
}

}  // namespace

void TableBuilder::results(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                           const std::vector<std::string>& keys) {
    const Table all = results_table(result, outputs);
    columns(all, keys);
    std::string group;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const Name& of = result.outputs[outputs[i]].quantity.group;
        if (of != group) subhead(said_name(of));
        group = of;
        block_.spreads.resize(block_.table.rows.size());
        block_.spreads.push_back(std::get<Measured>(all.cell(i, key_of_spread)).si);
        row(print_row(all, keys, i, in_));
    }
}

std::vector<TableCell> print_row(const Table& table, const std::vector<std::string>& keys, std::size_t row,
                                 const DocumentLanguage& in) {
    std::vector<TableCell> cells;
    for (const std::string& key : keys) cells.push_back(print_cell(table[key], row, in));
    return cells;
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

std::string short_list(const std::vector<std::string>& items, std::size_t most) {
    std::string out;
    const bool whole = items.size() <= most;
    const std::size_t shown = whole ? items.size() : most - 1;
    for (std::size_t i = 0; i < shown; ++i) out += (i ? ", " : "") + items[i];
    return whole ? out : out + " … " + items.back() + " (" + std::to_string(items.size()) + ")";
}

Text output_text(const OutputQuantity& quantity, const DocumentLanguage& in) {
    const Text symbol = symbol_text(quantity.symbol);
    return quantity.group.empty() ? symbol : symbol + (" (" + in.say(said_name(quantity.group)) + ")");
}

Message output_label(const OutputQuantity& quantity) {
    const std::string symbol = symbol_to_unicode(quantity.symbol);
    return quantity.group.empty() ? Message(symbol) : symbol + " (" + said_name(quantity.group) + ")";
}

Quantity value_in(const Unit& unit, double si) {
    return {unit.from_si(si), unit};
}

Quantity interval_in(const Unit& unit, double si) {
    return {unit.interval_from_si(si), unit};
}

namespace {

/// What is zero but for the rounding of a sum is shown as zero: beside the other figures of its column, of a
/// quantity with a unit, it is nothing.
void drop_rounding_errors(DataTable& table) {
    constexpr double rounding = 1e-14;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (table.columns[c].unit == Unit{}) continue;
        double largest = 0.0;
        const auto number = [c](std::vector<TableCell>& row) {
            return c < row.size() ? std::get_if<double>(&row[c]) : nullptr;
        };
        for (auto& row : table.rows)
            if (const double* value = number(row)) largest = std::max(largest, std::abs(*value));
        for (auto& row : table.rows)
            if (double* value = number(row); value && std::abs(*value) < rounding * largest) *value = 0.0;
    }
}

}  // namespace

TableBlock said_table(DataTable table, const DocumentLanguage& in) {
    table.title = in.say_declared(table.title);
    for (TableColumn& column : table.columns)
        if (!column.is_symbol) column.header = in.say_declared(column.header);
    for (Message& note : table.notes) note = in.say(note);
    for (std::vector<TableCell>& row : table.rows)
        for (TableCell& cell : row)
            if (const auto* words = std::get_if<Message>(&cell)) cell = TableCell(in.say(*words));
    drop_rounding_errors(table);
    return read_table(std::move(table), in.numbers());
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
