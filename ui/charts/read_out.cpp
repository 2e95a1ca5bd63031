// The value under the pointer, in words.
#include "ui/charts/read_out.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"
#include "ui/theme/number_locale.h"

namespace covaria::ui {
namespace {

/// "x = −120.3 mm"
Text named(const Text& title, const Text& number, const std::string& unit) {
    const bool is_sign = unit == "°" || unit == "′" || unit == "″";  // as in unit_after_number
    const std::string behind = unit.empty() ? "" : (is_sign ? "" : "\u00a0") + unit;
    return title + " = " + number + behind;
}

/// The value with decimals to a thousandth of the range that is shown.
Text value_text(const PlotAxis& axis, double value, double low, double high) {
    const double range = axis.logarithmic ? value : high - low;
    return named(axis.title,
                 grouped_number(value, std::max(0, decimals_for(1e-3 * range, 1)), user_numbers()),
                 axis.unit);
}

struct Reader {
    const PlotSpecification& plot;
    const PlotGeometry& geometry;

    Text x_text(double x) const { return value_text(plot.x, x, geometry.view.x_low, geometry.view.x_high); }
    Text y_text(double y) const { return value_text(plot.y, y, geometry.view.y_low, geometry.view.y_high); }

    std::optional<ReadOut> cell(const PlotSeries& map, QPointF at) const {
        const auto column = static_cast<std::size_t>(std::max(0.0, std::round(at.x())));
        const auto row = static_cast<std::size_t>(std::max(0.0, std::round(at.y())));
        const std::size_t columns = plot.x.categories.size();
        if (column >= columns || row >= plot.y.categories.size()) return {};
        const double z = map.z[row * columns + column];
        if (!std::isfinite(z)) return {};
        const double largest = std::max(std::abs(plot.z_low), std::abs(plot.z_high));
        const int decimals = std::max(0, decimals_for(largest == 1.0 ? 0.99 : largest, 3));
        const std::string number = grouped_number(z, decimals, user_numbers());
        const Text &x = plot.x.categories[column], &y = plot.y.categories[row];
        if (plot.x.title.empty() || plot.y.title.empty()) return ReadOut{y + "; " + x + ": " + number, {}};
        return ReadOut{named(plot.x.title, x, plot.x.unit) + "; " + named(plot.y.title, y, plot.y.unit) +
                           ": " + named(map.name, number, map.unit),
                       {}};
    }

    std::optional<ReadOut> bar(const PlotSeries& bars, QPointF at) const {
        const auto& centres = plot.horizontal_bars ? bars.y : bars.x;
        const double wanted = plot.horizontal_bars ? at.y() : at.x();
        for (std::size_t i = 0; i < centres.size(); ++i) {
            if (std::abs(centres[i] - wanted) > 0.5 * bars.bar_width) continue;
            if (plot.horizontal_bars)
                return ReadOut{plot.y.categories.at(i) + ": " + x_text(bars.x[i]), {}, i};
            return ReadOut{x_text(bars.x[i]) + ", " + y_text(bars.y[i]), {}};
        }
        return {};
    }

    std::optional<ReadOut> nearest(QPointF place, double reach) const {
        std::optional<ReadOut> found;
        for (const PlotSeries& series : plot.series) {
            if (series.kind != SeriesKind::line && series.kind != SeriesKind::points) continue;
            for (std::size_t i = 0; i < series.x.size(); ++i) {
                const QPointF at = geometry.at(on_axis(plot.x, series.x[i]), on_axis(plot.y, series.y[i]));
                const double distance = QLineF(place, at).length();
                if (distance >= reach || !geometry.area.adjusted(-1, -1, 1, 1).contains(at)) continue;
                reach = distance;
                const Text y = plot.y.categories.empty()
                                   ? y_text(series.y[i])
                                   : plot.y.categories.at(static_cast<std::size_t>(series.y[i]));
                found = ReadOut{x_text(series.x[i]) + ", " + y, at};
            }
        }
        return found;
    }
};

}  // namespace

std::optional<ReadOut> read_out(const PlotSpecification& plot, const PlotGeometry& geometry, QPointF place,
                                double reach) {
    if (!geometry.area.contains(place)) return {};
    const Reader reader{plot, geometry};
    const QPointF at = geometry.coordinates_at(place);
    for (const PlotSeries& series : plot.series) {
        if (series.kind == SeriesKind::heat_map) return reader.cell(series, at);
        if (series.kind == SeriesKind::bars)
            if (auto found = reader.bar(series, at)) return found;
    }
    return reader.nearest(place, reach);
}

}  // namespace covaria::ui
