// Charts of residuals: over their order, over what readings have, and their histogram.
#include "core/views/seen_plots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace covaria::seen_plots_test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

evidence::RedundantReadings readings() {
    evidence::RedundantReadings made;
    made.figures = {{.name = tell<"distances">()}, {.name = tell<"angles">()}};
    made.figure_of = {0, 1, 0, 0, 1};
    made.w = {0.5, -1.0, none, 2.0, 0.1};
    made.abscissas = {{tell<"distance">(), Unit::of("mm"), {1.0, none, 2.0, 3.0, 4.0}}};
    return made;
}

TEST(SeenPlots, ResidualsAreDrawnOverWhatReadingsHave) {
    const auto made = readings();
    ASSERT_EQ(residual_abscissas(made).size(), 2u);
    const PlotSpecification order = residual_plot(made, 0), over = residual_plot(made, 0, 1);
    EXPECT_EQ(order.series[0].x, (std::vector<double>{2.0, 5.0}));  // others
    EXPECT_EQ(order.series[1].x, (std::vector<double>{1.0, 4.0}));
    EXPECT_EQ(over.series[0].x, (std::vector<double>{4000.0}));
    EXPECT_EQ(over.series[0].y, (std::vector<double>{0.1}));
    EXPECT_EQ(over.series[1].x, (std::vector<double>{1000.0, 3000.0}));
    EXPECT_EQ(over.x.unit, "mm");
}

TEST(SeenPlots, TheHistogramHasTheResidualsOfItsFigureAndTheAreaOne) {
    const PlotSpecification plot = residual_histogram(readings(), 0);
    ASSERT_EQ(plot.series.size(), 2u);
    const PlotSeries& bars = plot.series[0];
    double area = 0.0, own = 0.0;
    for (std::size_t k = 0; k < bars.x.size(); ++k) {
        area += bars.y[k] * bars.bar_width;
        for (const double w : {0.5, 2.0})
            if (std::abs(w - bars.x[k]) <= 0.5 * bars.bar_width) own += 1.0 / (2.0 * bars.bar_width);
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
    EXPECT_NEAR(own * bars.bar_width, 1.0, 1e-12);
    const PlotSeries& normal = plot.series[1];
    double below = 0.0;
    for (std::size_t k = 1; k < normal.x.size(); ++k)
        below += 0.5 * (normal.y[k] + normal.y[k - 1]) * (normal.x[k] - normal.x[k - 1]);
    EXPECT_NEAR(below, 1.0, 1e-3);
}

TEST(SeenPlots, NothingIsDrawnOfReadingsThatNothingControls) {
    auto made = readings();
    made.w.assign(5, none);
    EXPECT_TRUE(residual_histogram(made, 0).series.empty());
    EXPECT_TRUE(quantile_plot(made, 0).series.empty());
}

}  // namespace
}  // namespace covaria::seen_plots_test
