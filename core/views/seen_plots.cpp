#include "core/views/seen_plots.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/text/symbol.h"

namespace covaria {
namespace {

constexpr double most_cells = 60.0;
constexpr int density_points = 60;
constexpr double outlier = 3.29;  // |w| that is exceeded with a probability of 0.1 %

Text words(const DocumentLanguage& in, const Message& message) {
    return running_text(in.say(message));
}

PlotSeries series(Text name, SeriesKind kind, SeriesRole role) {
    PlotSeries made;
    made.name = std::move(name);
    made.kind = kind;
    made.role = role;
    return made;
}

/// Readings that share what makes them uncertain are those of every figure.
bool is_of(const evidence::RedundantReadings& readings, std::size_t figure, std::size_t reading) {
    const std::size_t of = readings.figure_of[reading];
    return of == figure || (of == evidence::RedundantReadings::no_figure && !readings.shares.empty());
}

std::vector<double> w_of(const evidence::RedundantReadings& readings, std::size_t figure) {
    std::vector<double> w;
    for (std::size_t i = 0; i < readings.w.size(); ++i)
        if (is_of(readings, figure, i) && std::isfinite(readings.w[i])) w.push_back(readings.w[i]);
    return w;
}

}  // namespace

std::vector<Message> residual_abscissas(const evidence::RedundantReadings& readings) {
    std::vector<Message> names{tell<"order">()};
    for (const evidence::Abscissa& abscissa : readings.abscissas) names.push_back(abscissa.name);
    return names;
}

PlotSpecification residual_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                std::size_t abscissa, const DocumentLanguage& in) {
    const evidence::Abscissa* over = abscissa == 0 ? nullptr : &readings.abscissas[abscissa - 1];
    PlotSpecification plot;
    plot.id = over ? "seen-residuals-over-" + std::to_string(abscissa) : "seen-residuals";
    plot.title = words(in, tell<"Residuals over their standard uncertainties as stated">());
    plot.x.title = words(in, over ? over->name : tell<"reading">());
    if (over) plot.x.unit = over->unit.text();
    plot.y.title = symbols_text("w");
    PlotSeries others = series(words(in, tell<"others">()), SeriesKind::points, SeriesRole::reference);
    PlotSeries own =
        series(words(in, readings.figures[figure].name), SeriesKind::points, SeriesRole::emphasis);
    for (std::size_t i = 0; i < readings.w.size(); ++i) {
        const double x = over ? over->unit.from_si(over->values[i]) : static_cast<double>(i + 1);
        if (!std::isfinite(readings.w[i]) || !std::isfinite(x)) continue;
        PlotSeries& to = readings.figure_of[i] == figure ? own : others;
        to.x.push_back(x);
        to.y.push_back(readings.w[i]);
    }
    if (!others.x.empty()) plot.series.push_back(std::move(others));
    if (!own.x.empty()) plot.series.push_back(std::move(own));
    for (const double at : {-outlier, 0.0, outlier})
        plot.marks.push_back({{}, at, true, SeriesRole::reference});
    return plot;
}

PlotSpecification residual_histogram(const evidence::RedundantReadings& readings, std::size_t figure,
                                     const DocumentLanguage& in) {
    PlotSpecification plot;
    plot.id = "seen-histogram";
    plot.title = words(in, tell<"Histogram of the residuals">());
    plot.x.title = symbols_text("w");
    plot.y.title = words(in, tell<"probability density">());
    plot.y.short_title = words(in, tell<"density">());
    const std::vector<double> w = w_of(readings, figure);
    if (w.empty()) return plot;
    const auto [least, most] = std::ranges::minmax(w);
    const auto n = static_cast<double>(w.size());
    double squares = 0.0;
    for (const double value : w) squares += value * value;
    // The width of cells that suits normal values, by D. W. Scott, Biometrika 66 (1979) 605-610.
    const double width = std::max(3.49 * std::sqrt(squares / n) / std::cbrt(n), (most - least) / most_cells);
    if (!(width > 0.0)) return plot;
    const double first = std::floor(least / width);
    const auto cells = static_cast<std::size_t>(std::floor(most / width) - first) + 1;
    PlotSeries bars =
        series(words(in, readings.figures[figure].name), SeriesKind::bars, SeriesRole::emphasis);
    bars.bar_width = width;
    bars.y.assign(cells, 0.0);
    for (std::size_t k = 0; k < cells; ++k) bars.x.push_back((first + static_cast<double>(k) + 0.5) * width);
    for (const double value : w)
        bars.y[static_cast<std::size_t>(std::floor(value / width) - first)] += 1.0 / (n * width);
    PlotSeries line = series(words(in, tell<"as stated">()), SeriesKind::line, SeriesRole::reference);
    const double end = std::max({3.5, -least, most});
    for (int k = -density_points; k <= density_points; ++k) {
        line.x.push_back(end * k / density_points);
        line.y.push_back(normal_density(line.x.back()));
    }
    plot.series = {std::move(bars), std::move(line)};
    return plot;
}

PlotSpecification quantile_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                const DocumentLanguage& in) {
    PlotSpecification plot;
    plot.id = "seen-quantiles";
    plot.title = words(in, tell<"Quantiles of the residuals">());
    plot.x.title = words(in, tell<"normal distribution">());
    plot.y.title = symbols_text("w");
    PlotSeries own =
        series(words(in, readings.figures[figure].name), SeriesKind::points, SeriesRole::emphasis);
    own.y = w_of(readings, figure);
    std::ranges::sort(own.y);
    const auto n = static_cast<double>(own.y.size());
    for (std::size_t i = 0; i < own.y.size(); ++i)
        own.x.push_back(normal_quantile((static_cast<double>(i) + 0.5) / n));
    if (own.x.empty()) return plot;
    PlotSeries line = series(words(in, tell<"as stated">()), SeriesKind::line, SeriesRole::reference);
    line.x = line.y = {own.x.front(), own.x.back()};
    plot.series.push_back(std::move(line));
    plot.series.push_back(std::move(own));
    return plot;
}

}  // namespace covaria
