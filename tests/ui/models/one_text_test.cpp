// A number has one text: what a cell says in the window is what it says in print, of all tables of all
// projects that are shipped.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/made/load_project.h"
#include "core/report/report_parts.h"
#include "core/report/table_builder.h"
#include "core/views/result_columns.h"
#include "core/views/result_words.h"
#include "tests/core/shipped_projects.h"
#include "ui/models/budget_table_model.h"

namespace covaria::one_text_test {
namespace {

using report_parts::TableBuilder;

std::string printed(const TableBlock& block, const Column& column, std::size_t row) {
    return to_unicode(written(block.table, column, row, block.view));
}

class AnyTable : public ui::ColumnTableModel {
public:
    void show(Table table, std::vector<std::string> keys) {
        set_contents({}, std::move(table), std::move(keys), true);
    }
};

class Budget : public ui::BudgetTableModel {
public:
    using BudgetTableModel::key;
};

/// The columns that people see; returns the number of cells that were compared.
std::size_t expect_one_text(const Table& table, int digits, const std::string& of) {
    std::vector<std::string> keys;
    for (const Column& column : table.columns)
        if (!column.head.empty() || !column.title.empty()) keys.push_back(column.key);
    const DocumentLanguage language = ui::language_of_window();
    TableBuilder builder(table.id, "", language);
    builder.all_of(table, keys);
    TableBlock print = builder.take();
    print.view.digits = digits;
    AnyTable window;
    window.set_digits(digits);
    window.show(table, keys);
    for (std::size_t row = 0; row < table.rows; ++row)
        for (std::size_t c = 0; c < keys.size(); ++c)
            EXPECT_EQ(window.index(int(row), int(c)).data().toString().toStdString(),
                      printed(print, print.table.columns[c], row))
                << of << ", " << table.id << ", " << keys[c];
    return table.rows * keys.size();
}

/// The budgets as the report and the pane of the budget show them.
std::size_t expect_budgets_alike(const MadeProject& made, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    const DocumentLanguage language = ui::language_of_window();
    std::size_t cells = 0;
    const ReportDocument report = build_report(made, {evaluated}, {}, language);
    for (std::size_t output = 0; output < result.budget.rows.size(); ++output) {
        Budget window;
        window.set_digits(evaluated.analysis->style.digits.value_or(2));
        window.set_result(evaluated.result, output, true);
        const OutputQuantity& quantity = result.outputs[output].quantity;
        const std::string id = "budget-" + evaluated.analysis->id + "-" +
                               result_words::id_part(quantity.symbol + " " + quantity.group);
        for (const ReportBlock& block : report.blocks) {
            const auto* print = std::get_if<TableBlock>(&block);
            if (!print || print->table.id != id) continue;
            // Sums of further components and of all stand below the components.
            int rows = 0;
            while (rows < window.rowCount() && rows < int(print->table.rows) &&
                   number_in(print->table.cell(std::size_t(rows), "u")))
                ++rows;
            for (int c = 0; c < window.columnCount(); ++c) {
                const std::string& key = window.key(std::size_t(c));
                const Column* column = print->table.find(key);
                for (int row = 0; column && !column->hidden && row < rows; ++row) {
                    if (!number_in(column->cell(std::size_t(row)))) continue;
                    ++cells;
                    EXPECT_EQ(window.index(row, c).data().toString().toStdString(),
                              printed(*print, *column, std::size_t(row)))
                        << id << ", " << key;
                }
            }
        }
    }
    return cells;
}

constexpr std::size_t most_rows = 60;  // limits outputs, inputs and places that are compared

std::size_t expect_alike(const MadeProject& made, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    const std::string& of = evaluated.analysis->name;
    std::vector<std::size_t> outputs;
    for (std::size_t i = 0; i < std::min(most_rows, result.outputs.size()); ++i) outputs.push_back(i);
    std::vector<InputRow> inputs = all_shares(result.inputs);
    inputs.resize(std::min(most_rows, inputs.size()));
    std::vector<BudgetPlace> places = budget_places(result, 0);
    places.resize(std::min(most_rows, places.size()));
    std::size_t cells = 0;
    for (const int digits : {1, 2, 4}) {
        cells += expect_one_text(results_table(result, outputs), digits, of);
        cells += expect_one_text(budget_table(result, places, ui::language_of_window()), digits, of);
        cells += expect_one_text(inputs_table(result.inputs, inputs), digits, of);
        cells += expect_one_text(correlation_table(result, outputs), digits, of);
        cells +=
            expect_one_text(input_correlations_table(result.inputs, result.inputs->correlations), digits, of);
        cells += expect_one_text(regions_table(result), digits, of);
    }
    return cells +
           (result.inputs->quantities.size() <= most_rows ? expect_budgets_alike(made, evaluated) : 0);
}

TEST(OneText, OfEveryCellOfAllProjectsInTheWindowAndInPrint) {
    std::size_t cells = 0;
    for (const auto& file : shipped_projects()) {
        LoadedProject loaded = load_project(file);
        for (AnalysisEntry& analysis : loaded.project.analyses) analysis.options.method = Method::first_order;
        const auto made = MadeProject::make(loaded.project);
        for (const AnalysisEntry& analysis : loaded.project.analyses) {
            const auto prepared = made->analysis(analysis.id);
            if (!prepared || prepared->inputs.quantities.size() > 1000) continue;
            auto result = run_analysis(*prepared);
            if (!result) continue;
            cells += expect_alike(*made,
                                  {prepared, std::make_shared<const UncertaintyResult>(std::move(*result))});
        }
    }
    EXPECT_GT(cells, 10000u);
}

}  // namespace
}  // namespace covaria::one_text_test
