// The distribution charts: histogram and normal quantiles.
#include "core/report/plots.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/report/number_format.h"
#include "core/report/plots_parts.h"

namespace covaria {

using plot_parts::nothing_to_show;
using plot_parts::PlottedOutput;

namespace {

constexpr int curve_points = 161;

/// Density of N(mean, u^2) over [low, high], in display units.
PlotSeries normal_curve(const std::string& name, SeriesRole role, const CoverageInterval& range, double mean,
                        double u) {
    PlotSeries series{name, SeriesKind::line, role, {}, {}, {}, 0.0};
    for (int i = 0; i < curve_points; ++i) {
        const double x = range.low + (range.high - range.low) * i / (curve_points - 1);
        const double z = (x - mean) / u;
        series.x.push_back(x);
        series.y.push_back(std::exp(-0.5 * z * z) / (u * std::sqrt(2.0 * 3.14159265358979323846)));
    }
    return series;
}

PlotSeries density_bars(const Histogram& histogram, const Unit& unit) {
    PlotSeries bars{"trials", SeriesKind::bars, SeriesRole::data, {}, {}, {}, 0.0};
    double total = double(histogram.below + histogram.above);
    for (std::uint64_t count : histogram.counts) total += double(count);
    const double low = unit.from_si(histogram.low), high = unit.from_si(histogram.high);
    bars.bar_width = (high - low) / double(histogram.counts.size());
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        bars.x.push_back(low + (double(i) + 0.5) * bars.bar_width);
        bars.y.push_back(double(histogram.counts[i]) / (total * bars.bar_width));
    }
    return bars;
}

/// The part of the histogram's range that is worth showing.
CoverageInterval shown_range(const PlotSeries& bars) {
    const double top = *std::max_element(bars.y.begin(), bars.y.end());
    std::size_t first = 0, last = bars.x.size() - 1;
    while (first < last && bars.y[first] < 5e-4 * top) ++first;
    while (last > first && bars.y[last] < 5e-4 * top) --last;
    return {bars.x[first] - 1.5 * bars.bar_width, bars.x[last] + 1.5 * bars.bar_width};
}

}  // namespace

PlotSpecification histogram_plot(const UncertaintyResult& result, std::size_t output) {
    const PlottedOutput plotted(result, output);
    const MonteCarloOutput* mc = plotted.trials();
    const std::string id = plotted.id("histogram");
    if (!mc) return nothing_to_show(id, "Run Monte Carlo to see the distribution of " + plotted.label());
    if (!(mc->standard_uncertainty > 0.0) || mc->histogram.counts.empty())
        return nothing_to_show(id, plotted.label() + " has no uncertainty, so no distribution to show");
    const FirstOrderOutput& first = plotted.output().first_order;
    PlotSpecification plot;
    plot.id = id;
    plot.title = "Distribution of " + plotted.label();
    PlotSeries bars = density_bars(mc->histogram, plotted.output().quantity.unit);
    const CoverageInterval range = shown_range(bars);
    plot.x = {plotted.with_unit(plotted.symbol()), range.low, range.high, false, {}};
    plot.y = {plotted.density_title(), 0.0, 0.0, false, {}};
    plot.series.push_back(std::move(bars));
    plot.series.push_back(normal_curve("normal, Monte Carlo u", SeriesRole::fit, range,
                                       plotted.value(mc->mean), plotted.interval(mc->standard_uncertainty)));
    if (first.standard_uncertainty > 0.0)
        plot.series.push_back(normal_curve("normal, first order", SeriesRole::first_order, range,
                                           plotted.value(first.estimate),
                                           plotted.interval(first.standard_uncertainty)));
    plot.marks.push_back({"mean", plotted.value(mc->mean), false, SeriesRole::monte_carlo});
    plot.bands.push_back({format_significant(100.0 * result.coverage_probability, 4) + " % coverage interval",
                          plotted.value(mc->symmetric.low), plotted.value(mc->symmetric.high),
                          SeriesRole::monte_carlo});
    return plot;
}

PlotSpecification normal_quantile_plot(const UncertaintyResult& result, std::size_t output) {
    const PlottedOutput plotted(result, output);
    const MonteCarloOutput* mc = plotted.trials();
    const std::string id = plotted.id("quantiles");
    if (!mc) return nothing_to_show(id, "Run Monte Carlo to see the quantiles of " + plotted.label());
    if (!(mc->standard_uncertainty > 0.0) || mc->quantiles.empty())
        return nothing_to_show(id, plotted.label() + " has no uncertainty, so no quantiles to show");
    PlotSeries points{"Monte Carlo", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < mc->quantiles.size(); ++i) {
        points.x.push_back(normal_quantile((double(i) + 0.5) / double(mc->quantiles.size())));
        points.y.push_back(plotted.value(mc->quantiles[i]));
    }
    const double reach = points.x.back(), mean = plotted.value(mc->mean),
                 u = plotted.interval(mc->standard_uncertainty);
    PlotSpecification plot;
    plot.id = id;
    plot.title = "Normal quantiles of " + plotted.label();
    plot.x = {"quantile of the standard normal distribution", -3.0, 3.0, false, {}};
    plot.y = {plotted.with_unit(plotted.symbol()), 0.0, 0.0, false, {}};
    plot.series.push_back({"normal distribution",
                           SeriesKind::line,
                           SeriesRole::fit,
                           {-reach, reach},
                           {mean - reach * u, mean + reach * u},
                           {},
                           0.0});
    plot.series.push_back(std::move(points));
    return plot;
}

}  // namespace covaria
