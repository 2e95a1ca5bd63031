// The value under the pointer, in words.
#include "ui/charts/read_out.h"

#include <QLineF>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/report/number_format.h"
#include "ui/charts/ticks.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

QString shown_number(double value, int decimals) {
    return number_text(value, decimals, QLocale().decimalPoint().front());
}

/// "x = −120.3 mm" from the title "x (mm)", to a thousandth of the range that is shown.
QString value_text(const PlotAxis& axis, double value, double low, double high) {
    QString name = to_qt(axis.title), unit;
    const auto open = name.lastIndexOf(QLatin1String(" ("));
    if (open >= 0 && name.endsWith(u')')) {
        unit = name.mid(open + 2, name.size() - open - 3);
        name.truncate(open);
    }
    const double range = axis.logarithmic ? value : high - low;
    QString text = shown_number(value, std::max(0, decimals_for(1e-3 * range, 1)));
    if (!unit.isEmpty()) text += (unit == QStringLiteral("°") ? QString() : QString(QChar(0xa0))) + unit;
    return name + QStringLiteral(" = ") + text;
}

struct Reader {
    const PlotSpecification& plot;
    const PlotGeometry& geometry;

    QString x_text(double x) const {
        return value_text(plot.x, x, geometry.view.x_low, geometry.view.x_high);
    }
    QString y_text(double y) const {
        return value_text(plot.y, y, geometry.view.y_low, geometry.view.y_high);
    }

    std::optional<ReadOut> cell(const PlotSeries& map, QPointF at) const {
        const auto column = static_cast<std::size_t>(std::max(0.0, std::round(at.x())));
        const auto row = static_cast<std::size_t>(std::max(0.0, std::round(at.y())));
        const std::size_t columns = plot.x.categories.size();
        if (column >= columns || row >= plot.y.categories.size()) return {};
        const double z = map.z[row * columns + column];
        if (!std::isfinite(z)) return {};
        const double largest = std::max(std::abs(plot.z_low), std::abs(plot.z_high));
        const int decimals = std::max(0, decimals_for(largest == 1.0 ? 0.99 : largest, 3));
        return ReadOut{QStringLiteral("%1 and %2: %3")
                           .arg(to_qt(plot.y.categories[row]), to_qt(plot.x.categories[column]),
                                shown_number(z, decimals)),
                       {}};
    }

    std::optional<ReadOut> bar(const PlotSeries& bars, QPointF at) const {
        const auto& centres = plot.horizontal_bars ? bars.y : bars.x;
        const double wanted = plot.horizontal_bars ? at.y() : at.x();
        for (std::size_t i = 0; i < centres.size(); ++i) {
            if (std::abs(centres[i] - wanted) > 0.5 * bars.bar_width) continue;
            if (plot.horizontal_bars)
                return ReadOut{to_qt(plot.y.categories.at(i)) + QStringLiteral(": ") + x_text(bars.x[i]), {}};
            return ReadOut{x_text(bars.x[i]) + QStringLiteral(", ") + y_text(bars.y[i]), {}};
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
                const QString y = plot.y.categories.empty()
                                      ? y_text(series.y[i])
                                      : to_qt(plot.y.categories.at(static_cast<std::size_t>(series.y[i])));
                found = ReadOut{x_text(series.x[i]) + QStringLiteral(", ") + y, at};
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
