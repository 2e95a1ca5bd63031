#include "core/report/table_builder.h"

#include "core/base/placeholders.h"
#include "core/text/symbol.h"
#include "core/views/result_columns.h"

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
            column.unit.reset();  // the head states it
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

}  // namespace covaria::report_parts
