// The charts' data: known histogram, quantiles, shares, correlation and convergence, and what is said without
// them.
#include "core/views/plots.h"
#include "core/result_files/csv_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/views/result_columns.h"
#include "tests/core/views/plot_sample.h"

namespace covaria::plots_test {
namespace {

const PlotSeries* series_of(const PlotSpecification& plot, SeriesRole role) {
    const auto it = std::find_if(plot.series.begin(), plot.series.end(),
                                 [role](const PlotSeries& series) { return series.role == role; });
    return it == plot.series.end() ? nullptr : &*it;
}

double area_of(const PlotSeries& bars) {
    return bars.bar_width * std::accumulate(bars.y.begin(), bars.y.end(), 0.0);
}

TEST(HistogramPlot, IsTheDensityInDisplayUnits) {
    const PlotSpecification plot = histogram_plot(test::plot_sample(), 0);
    EXPECT_EQ(plot.id, "histogram-x-pose-7");
    EXPECT_EQ(to_unicode(plot.title), "Distribution of x (pose 7)");
    EXPECT_EQ(to_unicode(plot.x.title), "x");
    EXPECT_EQ(plot.x.unit, "mm");
    EXPECT_EQ(to_unicode(plot.y.title), "probability density");
    EXPECT_EQ(plot.y.unit, "1/mm");
    EXPECT_EQ(to_unicode(plot.y.short_title), "density");
    EXPECT_EQ(plot.x.exponent, 0) << "as the labels of its marks";
    const PlotSeries& bars = plot.series.at(0);
    EXPECT_EQ(bars.kind, SeriesKind::bars);
    EXPECT_NEAR(area_of(bars), 1.0, 1e-5);
    // Cells of the normal density at their middles: within second-order effects of their width, 0.1 u.
    for (std::size_t i = 0; i < bars.x.size(); ++i)
        EXPECT_NEAR(bars.y[i], normal_density((bars.x[i] + 120.0) / 0.367) / 0.367, 2e-3) << i;
    EXPECT_NEAR(*std::max_element(bars.y.begin(), bars.y.end()), 0.39894 / 0.367, 2e-3);
}

TEST(HistogramPlot, CountsTrialsOutsideItsCells) {
    UncertaintyResult result = test::plot_sample();
    result.outputs[0].monte_carlo->histogram.below = 1'000'000;
    EXPECT_NEAR(area_of(histogram_plot(result, 0).series.at(0)), 0.5, 1e-5);
}

TEST(HistogramPlot, MarksMeanAndCoverageIntervalAndBothNormals) {
    const PlotSpecification plot = histogram_plot(test::plot_sample(), 0);
    ASSERT_EQ(plot.marks.size(), 3U);
    EXPECT_NEAR(plot.marks[0].at, -120.0 - 1.959964 * 0.367, 1e-9);
    EXPECT_EQ(to_unicode(plot.marks[1].label), "mean −120.00\u00a0mm");
    EXPECT_NEAR(plot.marks[2].at, -120.0 + 1.959964 * 0.367, 1e-9);
    ASSERT_EQ(plot.bands.size(), 1U);
    EXPECT_EQ(to_unicode(plot.bands[0].label), "95\u00a0% coverage interval");
    EXPECT_EQ(plot.bands[0].low, plot.marks[0].at);
    const auto top = [&plot](SeriesRole role) {
        const PlotSeries* series = series_of(plot, role);
        return series ? *std::max_element(series->y.begin(), series->y.end()) : 0.0;
    };
    EXPECT_NEAR(top(SeriesRole::fit), 0.398942 / 0.367, 1e-6);
    EXPECT_NEAR(top(SeriesRole::first_order), 0.398942 / (1.06 * 0.367), 1e-6);
}

TEST(HistogramPlot, LabelsHaveTheDecimalSignThatIsAskedFor) {
    const UncertaintyResult result = test::plot_sample();
    const DocumentLanguage german("de", {.decimal = ","}, {});
    for (const PlotSpecification& plot :
         {histogram_plot(result, 0, {}, german), convergence_plot(result, 0, {}, german)}) {
        std::string labels;
        for (const PlotMark& mark : plot.marks) labels += to_unicode(mark.label) + "\n";
        EXPECT_NE(labels.find(','), std::string::npos) << labels;
        EXPECT_EQ(labels.find('.'), std::string::npos) << labels;
    }
}

// Numbers of some micrometres in metres need a power of ten: one for the axis and all marks on it.
TEST(HistogramPlot, MarksHaveThePowerOfTenOfTheirAxis) {
    UncertaintyResult result = test::plot_sample();
    OutputResult& y = result.outputs[0];
    MonteCarloOutput& mc = *y.monte_carlo;
    const double unit = mc.standard_uncertainty / 1.8e-8;  // mm: u = 18 nm
    for (double* number :
         {&y.estimate, &y.first_order.estimate, &mc.mean, &mc.symmetric.low, &mc.symmetric.high,
          &mc.histogram.low, &mc.histogram.high, &mc.minimum, &mc.maximum})
        *number = (*number + 0.120) / unit;  // its mean was -120 mm
    for (double* number :
         {&y.first_order.standard_uncertainty, &y.standard_uncertainty, &y.expanded_uncertainty,
          &mc.standard_uncertainty, &mc.standard_error_of_uncertainty})
        *number /= unit;
    for (ConvergencePoint& point : result.convergence) point.standard_uncertainty[0] /= unit;
    for (const PlotSpecification& plot : {histogram_plot(result, 0), convergence_plot(result, 0)}) {
        ASSERT_FALSE(plot.marks.empty()) << to_unicode(plot.title);
        const auto exponent = plot.id.starts_with("histogram") ? plot.x.exponent : plot.y.exponent;
        EXPECT_EQ(exponent, -6) << plot.id;
        for (const PlotMark& mark : plot.marks)
            EXPECT_NE(to_unicode(mark.label).find("×10⁻⁶\u00a0mm"), std::string::npos)
                << to_unicode(mark.label);
    }
}

TEST(HistogramPlot, JoinsCellsForFewTrials) {
    UncertaintyResult result = test::plot_sample();
    Histogram& histogram = result.outputs[0].monte_carlo->histogram;
    for (std::uint64_t& count : histogram.counts) count /= 10'000;  // about 100 trials remain
    const PlotSeries bars = histogram_plot(result, 0).series.at(0);
    // Scott: 3.49 u N^(-1/3) is about 0.77 u for 90 trials, that is 8 cells of 0.1 u.
    EXPECT_NEAR(bars.bar_width, 0.8 * 0.367, 1e-9);
    EXPECT_NEAR(area_of(bars), 1.0, 1e-12);
}

TEST(HistogramPlot, ReachesFromTheSmallestTrialToTheLargest) {
    UncertaintyResult result = test::plot_sample();
    MonteCarloOutput& mc = *result.outputs[0].monte_carlo;
    // Rectangular, with ends inside of cells: 28.4 of them.
    const double u = mc.standard_uncertainty, cell = (mc.histogram.high - mc.histogram.low) / 100.0;
    mc.minimum = mc.mean - 1.42 * u;
    mc.maximum = mc.mean + 1.42 * u;
    for (int i = 0; i < 100; ++i) {
        const double from = std::max(mc.histogram.low + i * cell, mc.minimum),
                     to = std::min(mc.histogram.low + (i + 1) * cell, mc.maximum);
        mc.histogram.counts[std::size_t(i)] =
            std::uint64_t(std::llround(1e6 * std::max(0.0, to - from) / (2.84 * u)));
    }
    const PlotSeries bars = histogram_plot(result, 0).series.at(0);
    ASSERT_GT(bars.x.size(), 10U);
    EXPECT_NEAR(bars.x.front() - 0.5 * bars.bar_width, -120.0 - 1.42 * 0.367, 1e-9);
    EXPECT_NEAR(bars.x.back() + 0.5 * bars.bar_width, -120.0 + 1.42 * 0.367, 1e-9);
    EXPECT_NEAR(area_of(bars), 1.0, 1e-9);
    for (const double density : bars.y) EXPECT_NEAR(density, 1.0 / (2.84 * 0.367), 1e-4);
}

TEST(HistogramPlot, NothingIsBeyondABoundOnOneSide) {
    UncertaintyResult result = test::plot_sample();
    MonteCarloOutput& mc = *result.outputs[0].monte_carlo;
    mc.minimum = mc.mean - 0.55 * mc.standard_uncertainty;
    mc.maximum = mc.mean + 7.0 * mc.standard_uncertainty;
    mc.histogram.above = 1;
    for (std::size_t i = 0; i < 44; ++i) mc.histogram.counts[i] = 0;
    const PlotSeries bars = histogram_plot(result, 0).series.at(0);
    EXPECT_NEAR(bars.x.front() - 0.5 * bars.bar_width, -120.0 - 0.55 * 0.367, 1e-9);
    EXPECT_NEAR(area_of(bars), 1.0, 1e-5);
}

TEST(HistogramPlot, LeavesOutFarTails) {
    UncertaintyResult result = test::plot_sample();
    Histogram& histogram = result.outputs[0].monte_carlo->histogram;
    const double width = (histogram.high - histogram.low) / 100.0;
    histogram.counts.resize(1000);  // 900 cells more to the right, with a single trial in the last
    histogram.counts.back() = 1;
    histogram.high += 900.0 * width;
    EXPECT_LT(histogram_plot(result, 0).x.high, -120.0 + 6.0 * 0.367);
}

TEST(QuantilePlot, PointsOfANormalLieOnTheLine) {
    const PlotSpecification plot = normal_quantile_plot(test::plot_sample(), 2);
    const PlotSeries *line = series_of(plot, SeriesRole::fit),
                     *points = series_of(plot, SeriesRole::monte_carlo);
    ASSERT_TRUE(line && points);
    ASSERT_EQ(points->x.size(), 199U);
    EXPECT_NEAR(points->x.front(), normal_quantile(0.5 / 199.0), 1e-12);
    EXPECT_NEAR(points->x[99], 0.0, 1e-12);
    for (std::size_t i = 0; i < points->x.size(); ++i)
        EXPECT_NEAR(points->y[i], 1174.909 + 0.15 * points->x[i], 1e-9);
    const double slope = (line->y.back() - line->y.front()) / (line->x.back() - line->x.front());
    EXPECT_NEAR(slope, 0.15, 1e-9);
}

TEST(ContributionPlot, SharesAddUpAndTheRestIsOneBar) {
    const PlotSpecification plot = contribution_plot(test::plot_sample(), 0, {}, 6);
    ASSERT_EQ(plot.y.categories.size(), 6U);
    EXPECT_EQ(to_unicode(plot.y.categories[0]), "p₁ₓ");
    EXPECT_EQ(to_unicode(plot.y.categories[1]), "length standard")
        << "a component of several quantities is called by its name";
    EXPECT_EQ(to_unicode(plot.y.categories.back()), "11 others");
    const PlotSeries& bars = plot.series.at(0);
    EXPECT_NEAR(std::accumulate(bars.x.begin(), bars.x.end(), 0.0), 100.0, 1e-9);
    EXPECT_EQ(bars.y.back(), 5.0);
    EXPECT_TRUE(plot.horizontal_bars);
    EXPECT_EQ(contribution_plot(test::plot_sample(), 0, {}, 16).y.categories.size(), 16U)
        << "nothing to merge";
}

TEST(ContributionPlot, TellsComponentsOfOneQuantityApart) {
    UncertaintyResult result = test::plot_sample();
    result.budget.components[2].quantities = result.budget.components[0].quantities;
    result.budget.components[2].name = "temperature";
    const PlotSpecification plot = contribution_plot(result, 0, {}, 6);
    EXPECT_EQ(to_unicode(plot.y.categories[0]), "p₁ₓ, calibration of the artefact");
    EXPECT_EQ(to_unicode(plot.y.categories[2]), "p₁ₓ, temperature");
}

TEST(ContributionPlot, ShowsOneAtATimeBesideFirstOrder) {
    UncertaintyResult result = test::plot_sample();
    for (BudgetRow& row : result.budget.rows[0])
        row.one_at_a_time = 0.5 * result.outputs[0].standard_uncertainty;
    const PlotSpecification plot = contribution_plot(result, 0, {}, 6);
    ASSERT_EQ(plot.series.size(), 2U);
    ASSERT_EQ(plot.series[1].x.size(), 5U);
    EXPECT_NEAR(plot.series[1].x[0], 25.0, 1e-9);
}

TEST(CorrelationPlot, ShowsTheOutputsOfItsTable) {
    UncertaintyResult result = test::plot_sample();
    for (std::size_t i = 1; i < result.outputs.size(); ++i)
        result.outputs[i].quantity.role = OutputRole::intermediate;
    const std::vector<std::size_t> outputs = outputs_to_correlate(result, "pose 7");
    EXPECT_GT(outputs.size(), 1U);
    EXPECT_EQ(correlation_plot(result, outputs).x.categories.size(), correlation_table(result, outputs).rows);
}

TEST(CorrelationPlot, IsTheMatrixOfTheGroup) {
    UncertaintyResult result = test::plot_sample();
    result.outputs.back().quantity.group = "pose 8";
    const PlotSpecification plot = correlation_plot(result, outputs_to_correlate(result, "pose 7"));
    ASSERT_EQ(plot.x.categories.size(), 5U);
    EXPECT_EQ(to_unicode(plot.x.categories[3]), "α");
    const std::vector<double>& z = plot.series.at(0).z;
    ASSERT_EQ(z.size(), 25U);
    EXPECT_NEAR(z[0], 1.0, 1e-12);
    EXPECT_NEAR(z[1], -0.8, 1e-12);
    EXPECT_NEAR(z[2 * 5 + 4], 0.64, 1e-12);
    EXPECT_EQ(plot.z_low, -1.0);
    EXPECT_EQ(plot.z_high, 1.0);
    EXPECT_EQ(to_unicode(correlation_plot(result, outputs_to_correlate(result, "")).y.categories.back()),
              "γ₇ (pose 8)");
    EXPECT_TRUE(correlation_plot(result, outputs_to_correlate(result, "pose 8")).series.empty());
}

TEST(ConvergencePlot, HasTwoStandardErrorsAndTheFinalValue) {
    const UncertaintyResult result = test::plot_sample();
    const PlotSpecification plot = convergence_plot(result, 0);
    EXPECT_TRUE(plot.x.logarithmic);
    ASSERT_EQ(plot.series.size(), 3U);
    const PlotSeries &u = plot.series[0], &low = plot.series[1], &high = plot.series[2];
    ASSERT_EQ(u.x.size(), 21U);
    EXPECT_EQ(u.x.back(), 1e6);
    // u/sqrt(2 N) at both ends, in mm.
    EXPECT_NEAR(high.y.back() - u.y.back(), 2.0 * 0.367 / std::sqrt(2e6), 1e-9);
    EXPECT_NEAR(u.y.front() - low.y.front(), 2.0 * 0.367 / std::sqrt(2e4), 1e-9);
    ASSERT_EQ(plot.marks.size(), 1U);
    EXPECT_TRUE(plot.marks[0].horizontal);
    EXPECT_NEAR(plot.marks[0].at, 0.367, 1e-12);
    EXPECT_EQ(to_unicode(plot.marks[0].label), "final u 0.367\u00a0mm");
}

TEST(ConvergencePlot, SaysWhenItHasNotStabilised) {
    UncertaintyResult result = test::plot_sample();
    result.stabilised = false;
    EXPECT_NE(to_unicode(convergence_plot(result, 0).title).find("(not stabilised)"), std::string::npos);
}

TEST(EmptyPlots, SayWhatToDo) {
    UncertaintyResult result = test::plot_sample();
    result.outputs[0].monte_carlo.reset();
    for (const auto& plot :
         {histogram_plot(result, 0), normal_quantile_plot(result, 0), convergence_plot(result, 0)}) {
        EXPECT_TRUE(plot.series.empty());
        EXPECT_TRUE(to_unicode(plot.title).starts_with("Run Monte Carlo to see ")) << to_unicode(plot.title);
    }
    result.budget.rows[0].clear();
    EXPECT_TRUE(contribution_plot(result, 0).series.empty());
    EXPECT_NE(
        to_unicode(contribution_plot(result, 0).title).find("give its inputs components of uncertainty"),
        std::string::npos);
    result.outputs[0].first_order.standard_uncertainty = 0.0;
    EXPECT_NE(to_unicode(contribution_plot(result, 0).title).find("of second order"), std::string::npos)
        << "there are components of uncertainty";
}

TEST(EmptyPlots, ZeroUncertaintyHasNoDistribution) {
    UncertaintyResult result = test::plot_sample();
    MonteCarloOutput& trials = *result.outputs[0].monte_carlo;
    trials.standard_uncertainty = 0.0;
    trials.histogram = {-0.12, -0.12, {1'000'000}, 0, 0};
    for (const auto& plot : {histogram_plot(result, 0), normal_quantile_plot(result, 0)}) {
        EXPECT_TRUE(plot.series.empty());
        EXPECT_NE(to_unicode(plot.title).find("same value in every trial"), std::string::npos)
            << to_unicode(plot.title);
    }
    result.outputs[1].monte_carlo->histogram.counts.clear();
    EXPECT_TRUE(histogram_plot(result, 1).series.empty());
    result.outputs[1].monte_carlo->quantiles.resize(2);
    EXPECT_TRUE(normal_quantile_plot(result, 1).series.empty());
}

TEST(PlotCsv, HasColumnsPerSeriesAndQuotesCommas) {
    PlotSpecification plot;
    plot.x.title = "x, y";
    plot.y.title = "u";
    plot.y.unit = "mm";
    plot.series.push_back({"a", SeriesKind::line, SeriesRole::data, {1.0, 2.5}, {0.1, 0.2}, {}, 0.0});
    plot.series.push_back({"", SeriesKind::line, SeriesRole::fit, {3.0}, {1e-9}, {}, 0.0});
    EXPECT_EQ(plot_csv(plot), "\"a: x, y\",a: u (mm),\"x, y\",u (mm)\r\n1,0.1,3,1e-09\r\n2.5,0.2,,\r\n");
    EXPECT_EQ(plot_csv({}), "");
}

TEST(PlotCsv, WritesCategoriesAndMatrices) {
    const UncertaintyResult result = test::plot_sample();
    const std::string bars = plot_csv(contribution_plot(result, 0, {}, 3));
    EXPECT_NE(bars.find(",p₁ₓ\r\n"), std::string::npos) << bars;
    EXPECT_NE(bars.find(",14 others\r\n"), std::string::npos) << bars;
    PlotSpecification map;
    map.x.categories = map.y.categories = {"x", "α"};
    map.series.push_back({"r", SeriesKind::heat_map, SeriesRole::data, {}, {}, {1.0, -0.5, 0.25, 1.0}, 0.0});
    EXPECT_EQ(plot_csv(map), "r,x,α\r\nx,1,-0.5\r\nα,0.25,1\r\n");
}

}  // namespace
}  // namespace covaria::plots_test
