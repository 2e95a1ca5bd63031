// Names of quantities in the tables of a set-up are symbols in the report, as they are in its other tables.
#include <gtest/gtest.h>

#include "core/document/document_writers.h"
#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "core/project/kind_lookup.h"
#include "core/report/report.h"
#include "tests/core/report/shown_cells.h"

namespace covaria::setup_symbols_test {
namespace {

TEST(SetupSymbols, AreSetHoweverShort) {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    const auto made = MadeProject::make(project);
    const auto prepared = made->analysis(project.analyses[0].id);
    const auto result = std::make_shared<const UncertaintyResult>(*run_analysis(*prepared));
    const ReportDocument report = build_report(*made, {{prepared, result}});
    for (const ReportBlock& block : report.blocks) {
        const auto* table = std::get_if<TableBlock>(&block);
        if (!table || table->table.id != "setup-quantities") continue;
        for (std::size_t row = 0; row < table->table.rows; ++row)
            if (std::get<std::string>(table->table.columns[0].cell(row)) == "theta") {
                EXPECT_EQ(test::plain_cell(*table, row, 0), "θ");
                EXPECT_EQ(test::plain_cell(*table, row, 1), "deviation of the bed's temperature from 20 °C");
                return;
            }
    }
    FAIL() << "there is no quantity theta";
}

TEST(SetupObservations, HaveTheDecimalsOfTheOneWithTheMost) {
    AnalysisEntry analysis;
    analysis.id = "budget";
    analysis.model = "measurement-equation";
    analysis.setup.values["equations"] = std::string("y = x");
    const FieldSpec* quantities = nullptr;
    const FieldSpec* observations = nullptr;
    for (const FieldSpec& field : schema_of(analysis)->fields()) {
        if (field.states_quantities) quantities = &field;
        if (field.observes_quantities) observations = &field;
    }
    ASSERT_TRUE(quantities && observations);
    SetupTable stated, observed;
    stated.rows = {std::vector<SetupCell>(quantities->columns.size())};
    stated.rows[0][SetupSchema::column(*quantities, "symbol")] = std::string("x");
    stated.rows[0][SetupSchema::column(*quantities, "unit")] = std::string("mm");
    stated.rows[0][SetupSchema::column(*quantities, "statement")] = std::string("observations");
    for (const double value : {4.99, 5.012, 5.0}) {
        observed.rows.emplace_back(observations->columns.size());
        observed.rows.back()[SetupSchema::column(*observations, "quantity")] = std::string("x");
        observed.rows.back()[SetupSchema::column(*observations, "value")] = value;
    }
    for (const ColumnSpec& column : quantities->columns) stated.units.push_back(column.unit);
    for (const ColumnSpec& column : observations->columns) observed.units.push_back(column.unit);
    analysis.setup.values[quantities->key] = stated;
    analysis.setup.values[observations->key] = observed;
    analysis.options.method = Method::first_order;
    Project project;
    project.analyses = {analysis};
    const auto made = MadeProject::make(project);
    const auto prepared = made->analysis("budget");
    ASSERT_TRUE(prepared);
    const auto result = std::make_shared<const UncertaintyResult>(*run_analysis(*prepared));
    const std::string report = to_markdown(build_report(*made, {{prepared, result}}));
    for (const char* written : {"| 4.990 |", "| 5.012 |", "| 5.000 |"})
        EXPECT_NE(report.find(written), std::string::npos) << written << report;
}

}  // namespace
}  // namespace covaria::setup_symbols_test
