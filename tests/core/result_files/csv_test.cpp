// CSV: quoting, full precision, units; the tables of a result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/made/evaluated_analysis.h"
#include "core/result_files/csv_text.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/result_tables.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/table_rows.h"

namespace covaria::csv_test {
namespace {

TEST(Csv, QuotesCommasQuotesAndLineBreaks) {
    Table table;
    table.add("a,b");
    table.add("c");
    table.row({std::string("say \"no\""), std::string("two\nlines")});
    table.row({std::string("plain"), Cell{}});
    EXPECT_EQ(to_csv(table), "\"a,b\",c\r\n\"say \"\"no\"\"\",\"two\nlines\"\r\nplain,\r\n");
}

TEST(Csv, WhatASpreadsheetWouldComputeIsShownInstead) {
    for (const char* formula : {"=1+1", "@SUM(A1)", "-2+3", "+cmd", "\t=1", " =1"})
        EXPECT_EQ(csv_text(formula).find_first_of('\''), csv_text(formula)[0] == '"' ? 1u : 0u) << formula;
    for (const char* text : {"-2.5", "+3", "-1e-9", "a=b", "b-2", "−4", ""}) EXPECT_EQ(csv_text(text), text);
}

// A German Excel takes a comma for no separator and a semicolon for one, whatever is in quotes.
TEST(Csv, SoIsWhatWouldBeACellOfItsOwnElsewhere) {
    EXPECT_EQ(csv_text("a;=1+1"), "a;'=1+1");
    EXPECT_EQ(csv_text("a; =1;@x,b"), "\"a;' =1;'@x,b\"");
    EXPECT_EQ(csv_text("a\t=1"), "a\t'=1");
    EXPECT_EQ(csv_text("a\n+b"), "\"a\n'+b\"");
    EXPECT_EQ(csv_text("1;-2;+3"), "1;-2;+3") << "numbers compute nothing";
}

TEST(Csv, ControlCharactersAreShown) {
    EXPECT_EQ(csv_text("\x1b[2Jno errors\x07\x7f"), "␛[2Jno errors␇␡");
    EXPECT_EQ(csv_text("two\r\nlines"), "\"two\nlines\"");
}

TEST(Csv, NumbersHaveFullPrecisionInTheUnitOfTheHead) {
    Table table;
    table.add("u").in(Unit::of("mm")).symbol().figure(2);
    table.row({0.1234567890123e-3});
    const std::string csv = to_csv(table);
    ASSERT_EQ(csv.substr(0, 8), "u (mm)\r\n");
    EXPECT_NEAR(std::strtod(csv.c_str() + 8, nullptr), 0.1234567890123, 1e-16);
}

TEST(Csv, QuantitiesOfDifferentUnitsGetAUnitColumn) {
    Table table;
    table.add("value");
    table.row({Quantity{1.5, Unit::of("mm")}});
    table.row({Quantity{2.0, Unit::of("deg")}});
    EXPECT_EQ(to_csv(table), "value,value unit\r\n1.5,mm\r\n2,deg\r\n");
}

TEST(Csv, AUnitColumnOfTheTableIsEnough) {
    Table table;
    table.add("unit");
    table.add("value");
    table.row({std::string("mm"), Quantity{1.5, Unit::of("mm")}});
    EXPECT_EQ(to_csv(table), "unit,value\r\nmm,1.5\r\n");
}

std::vector<std::string> ids_of(const std::vector<Table>& tables) {
    std::vector<std::string> ids;
    for (const Table& table : tables) ids.push_back(table.id);
    return ids;
}

TEST(ResultTables, HoldEverythingOfTheResult) {
    const UncertaintyResult result = test::sample_result();
    const std::vector<Table> tables = result_tables(test::sample_project(), test::sample_analysis(result));
    EXPECT_EQ(ids_of(tables),
              (std::vector<std::string>{"results", "budget", "covariance", "correlation", "inputs", "regions",
                                        "histograms", "convergence", "requirements"}));
    EXPECT_EQ(tables[0].rows, 78U);
    EXPECT_EQ(tables[1].rows, 78U * 18U);
    EXPECT_EQ(tables[2].rows, 78U);
    EXPECT_EQ(tables[4].rows, 126U);
}

// Files are made one by one, budgets output by output, with the same bytes.
TEST(ResultTables, FilesAreThoseOfTheTables) {
    const UncertaintyResult result = test::sample_result();
    const auto analysis = test::sample_analysis(result);
    std::vector<std::pair<std::string, std::string>> files;
    each_result_file(test::sample_project(), analysis,
                     [&](const std::string& id, const std::string& csv) { files.emplace_back(id, csv); });
    const std::vector<Table> tables = result_tables(test::sample_project(), analysis);
    ASSERT_EQ(files.size(), tables.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_EQ(files[i].first, tables[i].id);
        EXPECT_EQ(files[i].second, to_csv(tables[i])) << tables[i].id;
    }
}

// Of hundreds of outputs with thousands of components each hardly any matters.
TEST(ResultTables, BudgetsOfManyOutputsAddUpTheirSmallComponents) {
    UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    constexpr std::size_t outputs = 60, components = 1000, kept = 50'000 / outputs;
    const OutputResult output = result.outputs.front();
    result.outputs.assign(outputs, output);
    const BudgetRow row = result.budget.rows.front().front();
    std::vector<BudgetRow> rows(components, row);
    double sum = 0.0, of_small = 0.0;
    for (std::size_t i = 0; i < components; ++i) sum += static_cast<double>(i + 1);
    for (std::size_t i = 0; i < components; ++i) {
        rows[i].share = static_cast<double>(i + 1) / sum;
        if (i < components - kept) of_small += rows[i].share;
    }
    result.budget.rows.assign(outputs, rows);
    std::vector<OutputQuantity> quantities;
    for (const OutputResult& o : result.outputs) quantities.push_back(o.quantity);
    result.covariance = OutputCovariance(OutputBlocks::of(quantities));
    result.regions.clear();
    const Table budget = result_tables(test::sample_project(), test::sample_analysis(result))[1];
    EXPECT_EQ(budget.rows, outputs * (kept + 1));
    const auto number = [&](std::size_t i, const char* key) {
        return exact_quantity(budget.cell(i, key)).value_or(Quantity{}).value;
    };
    EXPECT_EQ(english_of(budget.cell(kept, "component")),
              std::to_string(components - kept) + " smaller components together");
    EXPECT_NEAR(number(kept, "share of variance"), of_small, 1e-12);
    EXPECT_NEAR(
        number(kept, "contribution"),
        output.quantity.unit.interval_from_si(output.first_order.standard_uncertainty) * std::sqrt(of_small),
        1e-9 * output.quantity.unit.interval_from_si(output.first_order.standard_uncertainty));
    double all = 0.0;
    for (std::size_t i = 0; i <= kept; ++i) all += number(i, "share of variance");
    EXPECT_NEAR(all, 1.0, 1e-12);
    EXPECT_NEAR(number(0, "share of variance"), rows[components - kept].share, 1e-15);
}

// The whole matrix of thousands of outputs would be gigabytes: a point has the pairs of its coordinates.
TEST(ResultTables, CovariancesOfThousandsOfOutputsAreThoseOfTheirGroups) {
    UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    result.outputs.resize(3);
    std::vector<OutputResult> point = result.outputs;
    const Eigen::Matrix3d of_point = result.covariance.whole().topLeftCorner<3, 3>();
    result.outputs.clear();
    constexpr std::size_t points = 600;
    for (std::size_t k = 0; k < points; ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            point[c].quantity.group = "P" + std::to_string(k);
            result.outputs.push_back(point[c]);
        }
    std::vector<OutputQuantity> quantities;
    for (const OutputResult& output : result.outputs) quantities.push_back(output.quantity);
    result.covariance = OutputCovariance(OutputBlocks::of(quantities));
    for (std::size_t k = 0; k < points; ++k) result.covariance.block(k) = of_point;
    result.regions.clear();
    const std::vector<Table> tables = result_tables(test::sample_project(), test::sample_analysis(result));
    const auto table =
        std::find_if(tables.begin(), tables.end(), [](const Table& t) { return t.id == "covariance"; });
    ASSERT_NE(table, tables.end());
    EXPECT_EQ(
        std::count_if(tables.begin(), tables.end(), [](const Table& t) { return t.id == "correlation"; }), 0);
    ASSERT_EQ(table->rows, 3 * points);
    for (const auto& row : test::rows_of(*table)) {
        EXPECT_EQ(std::get<std::string>(row[3]), "mm");
        if (std::get<std::string>(row[1]) != "x" || std::get<std::string>(row[2]) != "y") continue;
        EXPECT_NEAR(test::si_of(row[5]), 1e6 * of_point(0, 1), 1e-12);
        EXPECT_NEAR(test::si_of(row[6]),
                    of_point(0, 1) / point[0].standard_uncertainty / point[1].standard_uncertainty, 1e-12);
    }
}

TEST(ResultTables, CorrelationsOfInputsAreThereWithTheIdsOfTheBudget) {
    UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    InputSet inputs = result.inputs;
    inputs.correlations = {{0, 4, -0.36}};
    result.inputs = inputs;
    const std::vector<Table> tables = result_tables(test::sample_project(), test::sample_analysis(result));
    const auto table = std::find_if(tables.begin(), tables.end(),
                                    [](const Table& t) { return t.id == "input-correlations"; });
    ASSERT_NE(table, tables.end());
    EXPECT_EQ(to_csv(*table),
              "symbol,component,id,other symbol,other component,other id,r\r\n"
              "b_1x,coordinate of a point,b_1x.typed,p_1_1y,coordinate of a point,p_1_1y.typed,-0.36\r\n");
}

TEST(ResultTables, CovarianceIsInTheProductOfUnits) {
    const UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    const std::vector<Table> tables = result_tables(test::sample_project(), test::sample_analysis(result));
    const Table& covariance = tables[2];
    // row x (mm), column alpha (deg)
    const double shown = test::si_of(covariance.columns[2 + 3].cell(0));
    EXPECT_NEAR(shown, result.covariance(0, 3) * 1e3 * 180.0 / std::acos(-1.0), 1e-12);
    EXPECT_EQ(covariance.columns[2 + 3].key, "alpha (pose 1) × deg");
    EXPECT_EQ(std::get<std::string>(covariance.columns[1].cell(0)), "mm");
}

TEST(ResultTables, WithoutMonteCarloItsCellsAreEmpty) {
    const UncertaintyResult result = test::sample_result({1, 1, 1, false, "pose"});
    const std::vector<Table> tables = result_tables(test::sample_project(), test::sample_analysis(result));
    EXPECT_EQ(tables.size(), 7U);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(tables[0].cell(0, "shortest low")));
}

}  // namespace
}  // namespace covaria::csv_test
