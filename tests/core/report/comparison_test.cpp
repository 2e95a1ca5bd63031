// Results before and after against figures computed by hand: u_c^2 of x goes from 16 + 9 = 25 um^2 to
// 36 + 9 = 45 um^2.
#include "core/document/document_writers.h"
#include "core/result_files/csv_writer.h"
#include "core/views/comparison_columns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/report/comparison_report.h"
#include "tests/core/report/compared_sample.h"
#include "tests/core/views/plot_sample.h"

namespace covaria::comparison_test {
namespace {

using test::sample_comparison;

std::size_t row_of(const ResultComparison& comparison, const std::string& symbol) {
    for (std::size_t i = 0; i < comparison.outputs.size(); ++i) {
        const ComparedOutput& at = comparison.outputs[i];
        const OutputResult* of = comparison.output_after(at);
        if ((of ? of : comparison.output_before(at))->quantity.symbol == symbol) return i;
    }
    ADD_FAILURE() << symbol;
    return 0;
}

double number(const Table& table, std::size_t row, const char* key) {
    const Cell cell = table.cell(row, key);
    const auto* measured = std::get_if<Measured>(&cell);
    EXPECT_NE(measured, nullptr) << key;
    return measured ? measured->si : 0.0;
}

std::string text(const Table& table, std::size_t row, const char* key) {
    const Cell cell = table.cell(row, key);
    const auto* words = std::get_if<Message>(&cell);
    return words ? words->english() : std::get<std::string>(cell);
}

bool empty(const Table& table, std::size_t row, const char* key) {
    return std::holds_alternative<std::monostate>(table.cell(row, key));
}

TEST(Comparison, OutputsAreMatchedByGroupAndSymbolAndTheRestIsNamed) {
    const ResultComparison c = sample_comparison();
    ASSERT_EQ(c.outputs.size(), 4u);
    EXPECT_EQ(c.outputs[0].before, 1u);
    EXPECT_EQ(c.outputs[0].after, 0u);
    EXPECT_EQ(c.outputs[1].before, 0u);
    EXPECT_EQ(c.outputs[1].after, 1u);
    const Table table = compared_results_table(c);
    EXPECT_EQ(text(table, 0, "in"), "both");
    EXPECT_EQ(text(table, 2, "in"), "only after");
    EXPECT_EQ(std::get<Symbols>(table.cell(2, "symbol")), Symbols{"w"});
    EXPECT_EQ(text(table, 3, "in"), "only before");
    EXPECT_EQ(std::get<Symbols>(table.cell(3, "symbol")), Symbols{"z"});
    EXPECT_TRUE(empty(table, 3, "U after"));
    EXPECT_TRUE(empty(table, 3, "change of U"));
    EXPECT_TRUE(empty(table, 2, "U before"));
}

TEST(Comparison, AnOutputOfAnotherDimensionIsAnotherQuantity) {
    auto before = std::make_shared<UncertaintyResult>(*sample_comparison().before);
    auto after = std::make_shared<UncertaintyResult>(*before);
    after->outputs[0].quantity.unit = Unit::of("deg");
    after->outputs[1].quantity.unit = Unit::of("um");
    after->outputs[2].quantity.group = "pose 2";
    const ResultComparison c = compare_results(before, after);
    ASSERT_EQ(c.outputs.size(), 5u);
    EXPECT_FALSE(c.outputs[0].in_both());
    EXPECT_TRUE(c.outputs[1].in_both());
    EXPECT_FALSE(c.outputs[2].in_both());
    EXPECT_EQ(c.outputs[3].before, 0u);
    EXPECT_EQ(c.outputs[4].before, 2u);
}

TEST(Comparison, UStandsBesideUWithItsChange) {
    const ResultComparison c = sample_comparison();
    const Table table = compared_results_table(c, {row_of(c, "x")});
    ASSERT_EQ(table.rows, 1u);
    EXPECT_NEAR(number(table, 0, "U before"), 10e-6, 1e-18);
    EXPECT_NEAR(number(table, 0, "U after"), 2e-6 * std::sqrt(45.0), 1e-18);
    EXPECT_NEAR(number(table, 0, "change of U"), std::sqrt(45.0) / 5.0 - 1.0, 1e-12);
    EXPECT_NEAR(number(table, 0, "change of estimate"), 2e-6, 1e-16);
    EXPECT_EQ(to_unicode(written(table, table["change of U"], 0, {})), "34.2");
    EXPECT_EQ(number(table, 0, "k before"), 2.0);
}

TEST(Comparison, TheBudgetsDifferByWhatIsNewGoneAndTheSame) {
    const ResultComparison c = sample_comparison();
    const std::size_t x = row_of(c, "x");
    const std::vector<ComparedPlace> places = compared_places(c, x);
    ASSERT_EQ(places.size(), 3u);
    const Table table = compared_budget_table(c, places);
    EXPECT_EQ(text(table, 0, "component"), "temperature");
    EXPECT_EQ(text(table, 0, "what"), "new");
    EXPECT_NEAR(number(table, 0, "change of variance"), 36.0 / 25.0, 1e-12);
    EXPECT_TRUE(empty(table, 0, "u before"));
    EXPECT_NEAR(number(table, 0, "contribution after"), 6e-6, 1e-18);
    EXPECT_EQ(text(table, 1, "component"), "calibration");
    EXPECT_EQ(text(table, 1, "what"), "gone");
    EXPECT_NEAR(number(table, 1, "change of variance"), -16.0 / 25.0, 1e-12);
    EXPECT_TRUE(empty(table, 1, "u after"));
    EXPECT_EQ(text(table, 2, "component"), "drift") << "another id, the same name and quantity";
    EXPECT_EQ(text(table, 2, "what"), "same");
    EXPECT_NEAR(number(table, 2, "share before"), 9.0 / 25.0, 1e-12);
    EXPECT_NEAR(number(table, 2, "share after"), 9.0 / 45.0, 1e-12);
    EXPECT_NEAR(number(table, 2, "change of variance"), 0.0, 1e-12);
    double sum = 0.0;
    for (const ComparedPlace& place : places) sum += place.component.change();
    EXPECT_NEAR(sum, 20e-12, 1e-22);
}

TEST(Comparison, TheIdOfAComponentCountsBeforeItsName) {
    auto before = std::make_shared<UncertaintyResult>();
    test::add_sample_output(*before, "x", "", 0.0, {{"a", "noise", "L", 1.0}, {"b", "noise", "L", 2.0}});
    auto after = std::make_shared<UncertaintyResult>();
    test::add_sample_output(*after, "x", "", 0.0, {{"b", "noise", "L", 2.0}, {"a", "noise", "L", 1.5}});
    const ResultComparison c = compare_results(before, after);
    const auto components = compare_budgets(c, c.outputs[0]);
    ASSERT_EQ(components.size(), 2u);
    EXPECT_NEAR(components[0].change(), 1.25e-12, 1e-24);
    EXPECT_EQ(components[0].before, 0u);
    EXPECT_EQ(components[0].after, 1u);
    EXPECT_NEAR(components[1].change(), 0.0, 1e-24);
}

TEST(Comparison, NothingIsSaidAboutAChangeOfNothing) {
    EXPECT_FALSE(relative_change(0.0, 1.0));
    EXPECT_FALSE(relative_change(infinity, 1.0));
    EXPECT_EQ(relative_change(2.0, 1.0), -0.5);
}

TEST(Comparison, DistributionsLieOverEachOther) {
    const auto before = std::make_shared<const UncertaintyResult>(test::plot_sample());
    auto wider = test::plot_sample();
    wider.outputs[0].monte_carlo.reset();
    wider.outputs[0].first_order.standard_uncertainty = 0.001;
    wider.outputs[0].quantity.unit = Unit::of("um");
    const ResultComparison c =
        compare_results(before, std::make_shared<const UncertaintyResult>(std::move(wider)));
    const PlotSpecification plot = compared_distributions_plot(c, 0);
    ASSERT_EQ(plot.series.size(), 2u);
    EXPECT_EQ(to_unicode(plot.series[0].name), "before: Monte Carlo");
    EXPECT_EQ(to_unicode(plot.series[1].name), "after: normal, first order");
    for (const PlotSeries& series : plot.series) {
        EXPECT_EQ(series.kind, SeriesKind::line);
        double area = 0.0;
        for (std::size_t i = 1; i < series.x.size(); ++i)
            area += 0.5 * (series.y[i] + series.y[i - 1]) * (series.x[i] - series.x[i - 1]);
        EXPECT_NEAR(area, 1.0, 1e-3) << "a density in the unit of the axis, the same for both";
    }
    EXPECT_NEAR(plot.x.low, -120'000.0 - 4.5 * 1000.0, 1e-9);
    EXPECT_EQ(plot.x.unit, "µm");
}

/// The curve is of the distribution that k is from.
TEST(Comparison, FewDegreesOfFreedomAreDrawnAsStudentsT) {
    auto first = test::plot_sample();
    first.outputs[0].monte_carlo.reset();
    first.outputs[0].first_order.effective_degrees_of_freedom = 4.0;
    const auto result = std::make_shared<const UncertaintyResult>(std::move(first));
    const PlotSpecification plot = compared_distributions_plot(compare_results(result, result), 0);
    ASSERT_EQ(plot.series.size(), 2u);
    EXPECT_EQ(to_unicode(plot.series[1].name), "after: Student t, first order");
    const OutputResult& y = result->outputs[0];
    const double u = y.quantity.unit.interval_from_si(y.first_order.standard_uncertainty);
    const auto& density = plot.series[1].y;
    EXPECT_NEAR(*std::max_element(density.begin(), density.end()), 0.375 / u, 1e-9 / u);
}

TEST(Comparison, TheChangesOfABudgetAreBars) {
    const ResultComparison c = sample_comparison();
    const PlotSpecification plot = budget_changes_plot(c, row_of(c, "x"));
    ASSERT_EQ(plot.series.size(), 1u);
    ASSERT_EQ(plot.series[0].x.size(), 2u) << "what has not changed is no bar";
    EXPECT_NEAR(plot.series[0].x[0], 144.0, 1e-9);
    EXPECT_NEAR(plot.series[0].x[1], -64.0, 1e-9);
    EXPECT_EQ(to_unicode(plot.y.categories[0]), "θ");
    EXPECT_TRUE(budget_changes_plot(c, row_of(c, "y")).series.empty());
    EXPECT_TRUE(budget_changes_plot(c, row_of(c, "z")).series.empty());
}

TEST(Comparison, TheDocumentHasWhatChangedAndSaysWhatIsOnlyInOne) {
    const std::string text = to_markdown(
        build_comparison({"a.covaria", "b.covaria", {"old"}, {}}, {{"pose", "pose", sample_comparison()}}));
    for (const char* words : {"a.covaria", "b.covaria", "Only before: old.",
                              "2 of 4 measurands are in both results", "the budgets of 1 of them differ",
                              "only before", "only after", "34.2", "temperature", "gone", "144.0", "80.0"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    EXPECT_EQ(text.find("Only after: "), std::string::npos);
}

TEST(Comparison, FilesHaveEveryOutputAndComponent) {
    const std::vector<Table> tables = comparison_tables({"pose", "pose", sample_comparison()});
    ASSERT_EQ(tables.size(), 2u);
    EXPECT_EQ(tables[0].id, "pose-compared-results");
    EXPECT_EQ(tables[0].rows, 4u);
    EXPECT_EQ(tables[1].id, "pose-compared-budget");
    EXPECT_EQ(tables[1].rows, 4u) << "three of x, one of y";
    EXPECT_NE(to_csv(tables[0]).find("pose 1,x,length x,both,mm,0.01,"), std::string::npos)
        << to_csv(tables[0]);
}

}  // namespace
}  // namespace covaria::comparison_test
