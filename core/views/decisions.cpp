#include "core/views/decisions.h"

#include <algorithm>

#include "core/text/numbers.h"

namespace covaria {
namespace {

void add_part(Text& text, const Text& part, const char* between) {
    if (!text.empty()) text += between;
    text += part;
}

/// "E = 12.3 µm".
Text figure_of(const Table& table, const Column& column, std::size_t row, const TableView& view) {
    Text figure = column.title + " = " + written(table, column, row, view);
    if (column.unit) figure += unit_after_number(view.units.of(*column.unit));
    return figure;
}

DecidedRow decision_of(const Table& table, std::size_t row, const TestVerdict& verdict,
                       const TableView& view) {
    DecidedRow made{{}, verdict, {}};
    for (const Column& column : table.columns) {
        const Cell cell = column.cell(row);
        if (std::holds_alternative<std::monostate>(cell) || std::holds_alternative<TestVerdict>(cell))
            continue;
        if (number_in(cell))
            add_part(made.figures, figure_of(table, column, row, view), ", ");
        else if (made.figures.empty())
            add_part(made.subject, written(table, column, row, view), ", ");
    }
    made.subject = running_text(table.title) + ": " + made.subject;
    return made;
}

}  // namespace

std::vector<DecidedRow> decisions_in(const std::vector<Table>& tables, const TableView& view) {
    std::vector<DecidedRow> all;
    for (const Table& made : tables) {
        const Table table = evaluation_table(made, view.language);
        for (std::size_t row = 0; row < table.rows; ++row)
            for (const Column& column : table.columns) {
                const Cell cell = column.cell(row);
                if (const auto* verdict = std::get_if<TestVerdict>(&cell))
                    all.push_back(decision_of(table, row, *verdict, view));
            }
    }
    return all;
}

std::size_t count_of(const std::vector<DecidedRow>& rows, TestVerdict::Is is) {
    return static_cast<std::size_t>(
        std::ranges::count(rows, is, [](const DecidedRow& row) { return row.verdict.is; }));
}

}  // namespace covaria
