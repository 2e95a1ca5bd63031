// Distribution of an output by Monte Carlo: histogram, and quantiles against the normal distribution.
#include "core/views/plots.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/normal_quantile.h"
#include "core/text/numbers.h"
#include "core/views/plot_words.h"
#include "core/views/plots_parts.h"

namespace covaria {
namespace {

using plot_parts::curve;
using plot_parts::has_histogram;
using plot_parts::histogram_bars;
using plot_parts::nothing_to_show;
using plot_parts::PlottedOutput;

constexpr double tail_left_out = 1e-4;  // part of the trials on each side of the axis
constexpr double cells_per_u = 12.0;    // the most cells: finer ones are not told apart in print
constexpr std::size_t curve_points = 161;

/// The reason why there is no distribution; empty if the output has one to show.
Text missing_distribution(const PlottedOutput& y, const Phrase& run) {
    const MonteCarloOutput* trials = y.trials();
    if (!trials) return y.language().say_text(run, {y.label()});
    if (!(trials->standard_uncertainty > 0.0))
        return y.language().say_text(plot_words::same_in_every_trial, {y.label()});
    return {};
}

/// The spread that the width of a picture is measured by: u, or a quarter of the interval where u is
/// infinite.
double spread_of(const MonteCarloOutput& mc) {
    return std::isfinite(mc.standard_uncertainty) ? mc.standard_uncertainty
                                                  : 0.25 * (mc.symmetric.high - mc.symmetric.low);
}

/// The number of cells that are joined into one, so that their width suits the number of trials: 3.49 u
/// N^(-1/3), D. W. Scott, On optimal and data-based histograms, Biometrika 66 (1979) 605-610.
std::size_t cells_to_join(const Histogram& histogram, double u, double trials) {
    const auto cells = static_cast<double>(histogram.counts.size());
    const double width = (histogram.high - histogram.low) / cells;
    const double wanted = std::max(3.49 * u / std::cbrt(trials), u / cells_per_u);
    const double joined = std::round(wanted / width);
    // Cells with no width that a double can have stay as they are.
    return std::isfinite(joined)
               ? static_cast<std::size_t>(std::clamp(joined, 1.0, std::max(1.0, 0.25 * cells)))
               : 1;
}

double trials_of(const Histogram& histogram) {
    return static_cast<double>(
        std::accumulate(histogram.counts.begin(), histogram.counts.end(), histogram.below + histogram.above));
}

/// Bins of equal width.
struct Bins {
    double low = 0.0, width = 0.0;
    std::size_t count = 0;
};

/// The bins from the smallest trial to the largest, where the cells reach as far: a quantity that cannot pass
/// a bound has no bar beyond it.
Bins bins_of(const MonteCarloOutput& mc, double trials) {
    const Histogram& histogram = mc.histogram;
    const std::size_t cells = histogram.counts.size();
    const double step = (histogram.high - histogram.low) / static_cast<double>(cells);
    const double wanted = step * static_cast<double>(cells_to_join(histogram, spread_of(mc), trials));
    const bool known = mc.minimum < mc.maximum && mc.minimum < histogram.high && mc.maximum > histogram.low;
    const bool to_largest = known && mc.maximum < histogram.high;
    const double low = known ? std::max(mc.minimum, histogram.low) : histogram.low;
    const double room = ((to_largest ? mc.maximum : histogram.high) - low) / wanted;
    const double whole = to_largest ? std::round(room) : std::ceil(room - 1e-9);
    const double count = std::isfinite(whole) ? std::clamp(whole, 1.0, static_cast<double>(cells)) : 1.0;
    return {low, to_largest ? room * wanted / count : wanted, static_cast<std::size_t>(count)};
}

/// The number of trials of the cells that lie below `x`; those of one cell are evenly over as much of it as
/// lies between the bins' ends.
double trials_below(const Histogram& histogram, const Bins& bins, double x) {
    const double step = (histogram.high - histogram.low) / static_cast<double>(histogram.counts.size());
    const double end = bins.low + bins.width * static_cast<double>(bins.count);
    double below = 0.0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const double from = std::max(histogram.low + step * static_cast<double>(i), bins.low),
                     to = std::min(histogram.low + step * static_cast<double>(i + 1), end);
        const bool is_before = x >= std::min(from, end);  // decides for a cell with no room of its own
        const double part = to > from   ? std::clamp((x - from) / (to - from), 0.0, 1.0)
                            : is_before ? 1.0
                                        : 0.0;
        below += part * static_cast<double>(histogram.counts[i]);
    }
    return below;
}

/// Sets the range of the axis, which leaves out the extreme tails, because they would squeeze the rest.
void set_range(PlotAxis& axis, const PlotSeries& bars, const PlottedOutput& y) {
    const double half = 0.5 * bars.bar_width;
    double low = bars.x.back(), high = bars.x.front(), sum = 0.0;
    for (std::size_t i = 0; i < bars.x.size(); ++i) {
        const double before = sum;
        sum += bars.y[i] * bars.bar_width;
        if (sum > tail_left_out) low = std::min(low, bars.x[i] - half);
        if (before < 1.0 - tail_left_out && bars.y[i] > 0.0) high = std::max(high, bars.x[i] + half);
    }
    const MonteCarloOutput& mc = *y.trials();
    const double margin = 0.3 * y.interval(spread_of(mc));
    axis.low = std::min(low, y.value(mc.symmetric.low)) - margin;
    axis.high = std::max(high, y.value(mc.symmetric.high)) + margin;
}

double reach_of(const PlotAxis& axis) {
    return std::max(std::abs(axis.low), std::abs(axis.high));
}

PlotSeries normal_curve(const PlotAxis& axis, double mean, double u) {
    return curve(axis.low, axis.high, curve_points,
                 [&](double x) { return normal_density((x - mean) / u) / u; });
}

void add_curves(PlotSpecification& plot, const PlottedOutput& y) {
    const MonteCarloOutput& mc = *y.trials();
    const FirstOrderOutput& first = y.output().first_order;
    if (std::isfinite(mc.standard_uncertainty)) {
        PlotSeries fit = normal_curve(plot.x, y.value(mc.mean), y.interval(mc.standard_uncertainty));
        fit.name = y.language().say(plot_words::normal_of_moments);
        fit.role = SeriesRole::fit;
        plot.series.push_back(std::move(fit));
    }
    if (!(first.standard_uncertainty > 0.0)) return;
    plot.series.push_back(first_order_curve(y, plot.x.low, plot.x.high, curve_points));
}

void add_interval(PlotSpecification& plot, const PlottedOutput& y, double probability) {
    const MonteCarloOutput& mc = *y.trials();
    const double low = y.value(mc.symmetric.low), high = y.value(mc.symmetric.high);
    const std::string percent =
        typeset_number(format_typed(100.0 * probability), y.language().numbers()) + "\u00a0%";
    plot.bands.push_back(
        {y.language().say(plot_words::interval, {percent}), low, high, SeriesRole::reference});
    const int exponent = y.exponent_of_results(reach_of(plot.x));
    const auto text = [&](double si) { return y.result_text(si, exponent); };
    plot.marks.push_back({text(mc.symmetric.low), low, false, SeriesRole::reference});
    plot.marks.push_back(
        {y.language().say(plot_words::mean, {text(mc.mean)}), y.value(mc.mean), false, SeriesRole::emphasis});
    plot.marks.push_back({text(mc.symmetric.high), high, false, SeriesRole::reference});
    plot.x.exponent = exponent;
}

}  // namespace

bool plot_parts::has_histogram(const PlottedOutput& y) {
    if (!missing_distribution(y, plot_words::run_for_distribution).empty()) return false;
    const Histogram& histogram = y.trials()->histogram;
    return !histogram.counts.empty() && histogram.high > histogram.low && trials_of(histogram) > 0.0;
}

PlotSeries plot_parts::histogram_bars(const PlottedOutput& y) {
    const MonteCarloOutput& mc = *y.trials();
    const Histogram& histogram = mc.histogram;
    const double all = trials_of(histogram);
    const Bins bins = bins_of(mc, all);
    PlotSeries bars{
        y.language().say(plot_words::monte_carlo), SeriesKind::bars, SeriesRole::data, {}, {}, {}, 0.0};
    bars.bar_width = y.interval(bins.width);
    double before = 0.0;
    for (std::size_t i = 0; i < bins.count; ++i) {
        const auto place = static_cast<double>(i);
        const double below = trials_below(histogram, bins, bins.low + bins.width * (place + 1.0));
        bars.x.push_back(y.value(bins.low + bins.width * (place + 0.5)));
        bars.y.push_back((below - before) / (all * bars.bar_width));
        before = below;
    }
    return bars;
}

PlotSpecification histogram_plot(const UncertaintyResult& result, std::size_t output,
                                 const DisplayUnits& units, const DocumentLanguage& language) {
    const PlottedOutput y(result, output, units, language);
    const std::string id = y.id("histogram");
    if (const Text why = missing_distribution(y, plot_words::run_for_distribution); !why.empty())
        return nothing_to_show(id, why);
    if (!has_histogram(y))
        return nothing_to_show(id, language.say_text(plot_words::more_for_distribution, {y.label()}));
    PlotSpecification plot;
    plot.id = id;
    plot.title = language.say_text(plot_words::distribution, {y.label()});
    plot.x.title = y.symbol();
    plot.x.unit = y.unit();
    y.set_density_axis(plot.y);
    plot.series.push_back(histogram_bars(y));
    set_range(plot.x, plot.series.front(), y);
    add_curves(plot, y);
    add_interval(plot, y, result.coverage_probability);
    return plot;
}

PlotSpecification normal_quantile_plot(const UncertaintyResult& result, std::size_t output,
                                       const DisplayUnits& units, const DocumentLanguage& language) {
    const PlottedOutput y(result, output, units, language);
    const std::string id = y.id("quantiles");
    if (const Text why = missing_distribution(y, plot_words::run_for_quantiles); !why.empty())
        return nothing_to_show(id, why);
    const MonteCarloOutput& mc = *y.trials();
    const std::size_t n = mc.quantiles.size();
    if (n < 3) return nothing_to_show(id, language.say_text(plot_words::more_for_quantiles, {y.label()}));
    PlotSpecification plot;
    plot.id = id;
    plot.title = language.say_text(plot_words::normal_quantiles, {y.label()});
    plot.x.title = language.say(plot_words::standard_quantile);
    plot.y.title = language.say_text(plot_words::quantile, {y.symbol()});
    plot.y.short_title = language.say(plot_words::short_quantile);
    plot.y.unit = y.unit();
    const double largest =
        std::max(std::abs(y.value(mc.quantiles.front())), std::abs(y.value(mc.quantiles.back())));
    plot.y.exponent = y.exponent_of_results(largest);  // the exponent is that of the distribution beside it
    PlotSeries points{
        language.say(plot_words::monte_carlo), SeriesKind::points, SeriesRole::monte_carlo, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < n; ++i) {
        points.x.push_back(normal_quantile((static_cast<double>(i) + 0.5) / static_cast<double>(n)));
        points.y.push_back(y.value(mc.quantiles[i]));
    }
    const double reach = 1.04 * points.x.back();
    const double mean = y.value(mc.mean), u = y.interval(spread_of(mc));
    PlotSeries line = curve(-reach, reach, 2, [&](double z) { return mean + z * u; });
    line.name = language.say(std::isfinite(mc.standard_uncertainty) ? plot_words::normal_of_moments
                                                                    : plot_words::normal_of_interval);
    line.role = SeriesRole::fit;
    plot.series = {std::move(line), std::move(points)};
    return plot;
}

}  // namespace covaria
