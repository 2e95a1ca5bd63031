// Observations in the evaluation of a measurement equation: the Type A evaluation of each series, a chart of
// each quantity.
#include <gtest/gtest.h>

#include <cmath>

#include "core/kinds/equation/setup.h"
#include "tests/core/table_rows.h"

namespace covaria::equation_model::observations_test {
namespace {

/// JCGM 100 H.2: five observations of a voltage, in V.
ObservedQuantity voltage() {
    return {"V", "voltage", Unit::of("V"), {{"", {5.007, 4.994, 5.005, 4.990, 4.999}}}};
}

std::vector<Cell> row(const Table& table, std::size_t at) {
    return test::rows_of(table).at(at);
}

TEST(Observations, TheTableHasMeanDeviationAndUncertaintyOfTheMean) {
    const auto tables = observation_tables({voltage()});
    ASSERT_EQ(tables.size(), 1u);
    const std::vector<Cell> v = row(tables.front(), 0);
    EXPECT_EQ(std::get<std::string>(v[0]), "V");
    EXPECT_EQ(test::si_of(v[1]), 5.0);
    EXPECT_NEAR(std::get<Quantity>(v[2]).value, 4.9990, 1e-12);
    // The sum of squares by hand is 0.000206, s^2 = 0.0000515.
    EXPECT_NEAR(std::get<Quantity>(v[3]).value, std::sqrt(0.000206 / 4), 1e-12);
    EXPECT_NEAR(std::get<Quantity>(v[4]).value, 0.0032, 5e-5) << "published";
    EXPECT_EQ(test::si_of(v[5]), 4.0);
}

TEST(Observations, FiguresAreInTheUnitOfTheQuantity) {
    ObservedQuantity t{"t", "temperature", Unit::of("degC"), {{"", {20.1, 20.3, 20.2}}}};
    const Table table = observation_tables({t}).front();
    EXPECT_NEAR(std::get<Quantity>(row(table, 0)[2]).value, 20.2, 1e-12);
    EXPECT_EQ(std::get<Quantity>(row(table, 0)[2]).unit, Unit::of("degC"));
    EXPECT_NEAR(std::get<Quantity>(row(table, 0)[3]).value, 0.1, 1e-12);
    EXPECT_EQ(std::get<Quantity>(row(table, 0)[3]).unit, Unit::of("degC").interval());
}

TEST(Observations, SeriesAreTold) {
    ObservedQuantity x{"x", "x", Unit(), {{"", {1.0, 2.0}}, {"day 1", {1.5, 2.5, 2.0}}, {"day 2", {3.0}}}};
    const Table table = observation_tables({x}).front();
    ASSERT_EQ(table.rows, 2u) << "one observation has no deviation";
    EXPECT_EQ(std::get<std::string>(row(table, 1)[0]), "x, day 1");
    const PlotSpecification chart = observation_figures({x}).front();
    ASSERT_EQ(chart.series.size(), 3u);
    EXPECT_EQ(chart.series[1].x, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(chart.series[1].y, (std::vector<double>{1.5, 2.5, 2.0}));
    EXPECT_NE(chart.series[0].role, chart.series[1].role);
    ASSERT_FALSE(chart.marks.empty());
    EXPECT_EQ(chart.marks.front().at, 1.5) << "mean of the series that is measured now";
}

TEST(Observations, AChartSaysWhichQuantityItIsAbout) {
    const auto charts = observation_figures({voltage()});
    ASSERT_EQ(charts.size(), 1u);
    EXPECT_EQ(charts.front().quantity, "V");
    ASSERT_EQ(charts.front().marks.size(), 3u);
    EXPECT_NEAR(charts.front().marks[1].at - charts.front().marks[0].at, std::sqrt(0.000206 / 4), 1e-12);
    EXPECT_TRUE(observation_figures({}).empty());
    EXPECT_TRUE(observation_tables({}).empty());
}

}  // namespace
}  // namespace covaria::equation_model::observations_test
