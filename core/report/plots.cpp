// The distribution charts: histogram, normal quantiles, convergence.
#include "core/report/plots.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/report/plot_parts.h"

namespace covaria {
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
    const OutputResult& out = result.outputs[output];
    PlotSpecification plot = plot_frame("histogram", out, "Distribution of " + plot_name(out.quantity));
    if (!out.monte_carlo) return without_monte_carlo(std::move(plot));
    const MonteCarloOutput& mc = *out.monte_carlo;
    if (!(mc.standard_uncertainty > 0.0) || mc.histogram.counts.empty())
        return without_spread(std::move(plot));
    const Unit& unit = out.quantity.unit;
    PlotSeries bars = density_bars(mc.histogram, unit);
    const CoverageInterval range = shown_range(bars);
    plot.x = {axis_title(out.quantity), range.low, range.high, false, {}};
    plot.y = {"probability density (" + inverse_unit(unit) + ")", 0.0, 0.0, false, {}};
    plot.series.push_back(std::move(bars));
    plot.series.push_back(normal_curve("normal, Monte Carlo u", SeriesRole::fit, range, unit.from_si(mc.mean),
                                       unit.interval_from_si(mc.standard_uncertainty)));
    if (out.first_order.standard_uncertainty > 0.0)
        plot.series.push_back(normal_curve("normal, first order", SeriesRole::first_order, range,
                                           unit.from_si(out.first_order.estimate),
                                           unit.interval_from_si(out.first_order.standard_uncertainty)));
    plot.marks.push_back({"mean", unit.from_si(mc.mean), false, SeriesRole::monte_carlo});
    plot.bands.push_back({percent(result.coverage_probability) + " coverage interval",
                          unit.from_si(mc.symmetric.low), unit.from_si(mc.symmetric.high),
                          SeriesRole::monte_carlo});
    return plot;
}

PlotSpecification normal_quantile_plot(const UncertaintyResult& result, std::size_t output) {
    const OutputResult& out = result.outputs[output];
    PlotSpecification plot = plot_frame("quantiles", out, "Normal quantiles of " + plot_name(out.quantity));
    if (!out.monte_carlo) return without_monte_carlo(std::move(plot));
    const MonteCarloOutput& mc = *out.monte_carlo;
    if (!(mc.standard_uncertainty > 0.0) || mc.quantiles.empty()) return without_spread(std::move(plot));
    const Unit& unit = out.quantity.unit;
    PlotSeries points{"Monte Carlo", SeriesKind::points, SeriesRole::data, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < mc.quantiles.size(); ++i) {
        points.x.push_back(normal_quantile((double(i) + 0.5) / double(mc.quantiles.size())));
        points.y.push_back(unit.from_si(mc.quantiles[i]));
    }
    const double reach = points.x.back(), mean = unit.from_si(mc.mean),
                 u = unit.interval_from_si(mc.standard_uncertainty);
    plot.x = {"quantile of the standard normal distribution", -3.0, 3.0, false, {}};
    plot.y = {axis_title(out.quantity), 0.0, 0.0, false, {}};
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

PlotSpecification convergence_plot(const UncertaintyResult& result, std::size_t output) {
    const OutputResult& out = result.outputs[output];
    PlotSpecification plot =
        plot_frame("convergence", out, "Convergence of u(" + plot_name(out.quantity) + ")");
    if (!out.monte_carlo || result.convergence.empty()) return without_monte_carlo(std::move(plot));
    const Unit& unit = out.quantity.unit;
    PlotSeries u{"u after M trials", SeriesKind::line, SeriesRole::monte_carlo, {}, {}, {}, 0.0};
    PlotSeries low{"± 2 standard errors", SeriesKind::line, SeriesRole::reference, {}, {}, {}, 0.0},
        high = low;
    high.name.clear();
    const double final_u = unit.interval_from_si(out.monte_carlo->standard_uncertainty);
    const double kurtosis =
        std::max(0.0, out.monte_carlo->kurtosis + 2.0);  // (beta_2 - 1) of gum_algorithms 3.6
    for (const ConvergencePoint& point : result.convergence) {
        const double trials = double(point.trials);
        const double twice = 2.0 * final_u * std::sqrt(kurtosis / (4.0 * trials));
        u.x.push_back(trials);
        u.y.push_back(unit.interval_from_si(point.standard_uncertainty[output]));
        low.x.push_back(trials);
        low.y.push_back(final_u - twice);
        high.x.push_back(trials);
        high.y.push_back(final_u + twice);
    }
    plot.x = {"trials M", 0.0, 0.0, true, {}};
    plot.y = {"u(" + plot_name(out.quantity) + ")" + in_unit_words(unit), 0.0, 0.0, false, {}};
    plot.series = {low, high, u};
    plot.marks.push_back({"first order", unit.interval_from_si(out.first_order.standard_uncertainty), true,
                          SeriesRole::first_order});
    return plot;
}

}  // namespace covaria
