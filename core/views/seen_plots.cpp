#include "core/views/seen_plots.h"

#include <algorithm>
#include <cmath>

#include "core/math/normal_quantile.h"
#include "core/text/symbol.h"

namespace covaria {
namespace {

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

}  // namespace

PlotSpecification residual_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                const DocumentLanguage& in) {
    PlotSpecification plot;
    plot.id = "seen-residuals";
    plot.title = words(in, tell<"Residuals over their standard uncertainties as stated">());
    plot.x.title = words(in, tell<"reading">());
    plot.y.title = symbols_text("w");
    PlotSeries others = series(words(in, tell<"others">()), SeriesKind::points, SeriesRole::reference);
    PlotSeries own =
        series(words(in, readings.figures[figure].name), SeriesKind::points, SeriesRole::emphasis);
    for (std::size_t i = 0; i < readings.w.size(); ++i) {
        if (!std::isfinite(readings.w[i])) continue;
        PlotSeries& to = readings.figure_of[i] == figure ? own : others;
        to.x.push_back(static_cast<double>(i + 1));
        to.y.push_back(readings.w[i]);
    }
    if (!others.x.empty()) plot.series.push_back(std::move(others));
    if (!own.x.empty()) plot.series.push_back(std::move(own));
    for (const double at : {-outlier, 0.0, outlier})
        plot.marks.push_back({{}, at, true, SeriesRole::reference});
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
    for (std::size_t i = 0; i < readings.w.size(); ++i)
        if ((readings.figure_of[i] == figure || !readings.shares.empty()) && std::isfinite(readings.w[i]))
            own.y.push_back(readings.w[i]);
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
