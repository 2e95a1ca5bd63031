// Charts of any finite figures have an end: few ticks, places that are numbers, a picture.
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <tuple>

#include "tests/random_figures.h"
#include "tests/ui/charts/chart_test.h"
#include "ui/charts/chart_layout.h"

namespace covaria::ui::any_figures_test {
namespace {

constexpr QSize size(360, 240);

void expect_a_chart(const PlotSpecification& plot, const std::string& what) {
    const PlotView view = whole_view(plot);
    if (!plot.series.empty()) {
        EXPECT_GT(view.x_high, view.x_low) << what;
        EXPECT_GT(view.y_high, view.y_low) << what;
        EXPECT_TRUE(std::isfinite(view.x_high - view.x_low) && std::isfinite(view.y_high - view.y_low))
            << what;
    }
    const ChartLayout layout = layout_chart(plot, size, view);
    EXPECT_LE(layout.x.ticks.size() + layout.y.ticks.size(), 40u) << what;
    for (const PlacedText& text : layout.texts)
        EXPECT_TRUE(std::isfinite(text.box.x()) && std::isfinite(text.box.y())) << what;
    EXPECT_FALSE(plot_image({plot, Theme::light(), size, std::nullopt}, 1.0).isNull()) << what;
}

/// The results of the plots' sample, with trials and distributions, for other figures.
UncertaintyResult result_of(double mean, double u) {
    UncertaintyResult result = covaria::test::plot_sample();
    for (OutputResult& output : result.outputs) {
        output.estimate = output.first_order.estimate = mean;
        output.standard_uncertainty = output.first_order.standard_uncertainty = u;
        output.expanded_uncertainty = 2.0 * u;
        MonteCarloOutput trials = covaria::test::normal_trials(mean, u);
        trials.minimum = trials.histogram.low;
        trials.maximum = trials.histogram.high;
        output.monte_carlo = trials;
    }
    return result;
}

TEST(Charts, OfAnyResultHaveAnEnd) {
    covaria::test::RandomFigures figures(7);
    for (int i = 0; i < 40; ++i) {
        const auto [mean, beyond] = figures.range();
        const double u = figures.below(2) == 0 ? std::abs(figures.any()) : 0.5 * beyond - 0.5 * mean;
        const std::string what =
            "mean " + std::to_string(mean) + ", u " + std::to_string(u) + ", case " + std::to_string(i);
        const UncertaintyResult result = result_of(mean, u);
        for (const PlotSpecification& plot : {histogram_plot(result, 0), normal_quantile_plot(result, 2),
                                              contribution_plot(result, 0), convergence_plot(result, 3)})
            expect_a_chart(plot, plot.id + ", " + what);
        if (testing::Test::HasFailure()) return;
    }
}

// The second as the hydrogen and caesium clocks of today have it.
TEST(Charts, OfAClockHaveAnEnd) {
    for (const double u : {1e-12, 1e-7, 1e-6, 2e-6, 1e-5})
        for (const PlotSpecification& plot : {histogram_plot(result_of(9'192'631'770.0, u), 0),
                                              normal_quantile_plot(result_of(9'192'631'770.0, u), 0)})
            expect_a_chart(plot, std::to_string(u));
}

TEST(Charts, OfAnySeriesHaveAnEnd) {
    covaria::test::RandomFigures figures(8);
    for (int i = 0; i < 300; ++i) {
        PlotSpecification plot;
        plot.id = "any";
        plot.title = "any";
        plot.x.title = "x";
        plot.y.title = "y";
        plot.x.logarithmic = figures.below(4) == 0;
        plot.y.logarithmic = figures.below(4) == 0;
        for (const SeriesKind kind : {SeriesKind::line, SeriesKind::points, SeriesKind::bars}) {
            if (figures.below(2) == 0) continue;
            PlotSeries series;
            series.kind = kind;
            const auto [x_low, x_high] = figures.range();
            const auto [y_low, y_high] = figures.range();
            for (int k = 0; k < 5; ++k) {
                series.x.push_back(k % 2 ? x_low : x_high);
                series.y.push_back(k % 3 ? y_low : y_high);
            }
            series.bar_width = std::abs(figures.any());
            plot.series.push_back(series);
        }
        if (plot.series.empty()) continue;
        if (figures.below(3) == 0) plot.marks.push_back({"here", figures.any(), figures.below(2) == 0});
        if (figures.below(3) == 0) std::tie(plot.x.low, plot.x.high) = figures.range();
        expect_a_chart(plot, "case " + std::to_string(i));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(Charts, OfAnyMapHaveAnEnd) {
    covaria::test::RandomFigures figures(9);
    for (int i = 0; i < 100; ++i) {
        PlotSpecification plot;
        plot.id = "map";
        plot.x.categories = plot.y.categories = {"1", "2"};
        std::tie(plot.z_low, plot.z_high) = figures.range();
        PlotSeries cells;
        cells.kind = SeriesKind::heat_map;
        cells.z = {plot.z_low, plot.z_high, figures.any(), figures.any()};
        plot.series = {cells};
        expect_a_chart(plot, "case " + std::to_string(i));
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace
}  // namespace covaria::ui::any_figures_test
