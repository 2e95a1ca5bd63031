// Draws what Qt Charts does not.
#include "ui/charts/chart_drawing.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"
#include "ui/theme/label_text.h"

namespace covaria::ui {
namespace {

/// The middle of a pixel: hair lines stay sharp on the screen.
double sharp(double coordinate) {
    return std::floor(coordinate) + 0.5;
}

void draw_bands(QPainter& painter, const ChartDrawing& chart) {
    const PlotGeometry& geometry = chart.layout.geometry;
    for (const PlotBand& band : chart.plot.bands) {
        const double left = geometry.x_at(on_axis(chart.plot.x, band.low));
        const double right = geometry.x_at(on_axis(chart.plot.x, band.high));
        const QRectF rect(QPointF(left, geometry.area.top()), QPointF(right, geometry.area.bottom()));
        painter.fillRect(rect.intersected(geometry.area), chart.theme.tokens().hover);
    }
}

void draw_grid(QPainter& painter, const ChartDrawing& chart) {
    const QRectF& area = chart.layout.geometry.area;
    painter.setPen(QPen(chart.theme.tokens().line, 1.0));
    if (!chart.plot.horizontal_bars)
        for (const Tick& tick : chart.layout.y.ticks) {
            const double y = sharp(chart.layout.geometry.y_at(tick.at));
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
    if (chart.plot.bands.empty())
        for (const Tick& tick : chart.layout.x.ticks) {
            const double x = sharp(chart.layout.geometry.x_at(tick.at));
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        }
}

/// A histogram is one outline: no seams between its cells. Runs of cells outside the area are left out.
void draw_histogram(QPainter& painter, const ChartDrawing& chart, const PlotSeries& series) {
    const PlotGeometry& geometry = chart.layout.geometry;
    const QRectF& area = geometry.area;
    const auto inside = [&area](QPointF p) {
        return QPointF(std::clamp(p.x(), area.left(), area.right()),
                       std::clamp(p.y(), area.top(), area.bottom()));
    };
    QPolygonF steps;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const double left = series.x[i] - 0.5 * series.bar_width,
                     right = series.x[i] + 0.5 * series.bar_width;
        if (right < geometry.view.x_low || left > geometry.view.x_high) continue;
        if (steps.isEmpty()) steps << inside(geometry.at(left, 0.0));
        steps << inside(geometry.at(left, series.y[i])) << inside(geometry.at(right, series.y[i]));
    }
    if (steps.isEmpty()) return;
    steps << QPointF(steps.constLast().x(), inside(geometry.at(0.0, 0.0)).y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(chart.theme.filling(series.role));
    painter.drawPolygon(steps);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mix(chart.theme.series(series.role), chart.theme.tokens().stage, 0.2), 0.8));
    painter.drawPolyline(steps);
}

void draw_horizontal_bars(QPainter& painter, const ChartDrawing& chart, const PlotSeries& series) {
    const PlotGeometry& geometry = chart.layout.geometry;
    painter.setPen(Qt::NoPen);
    painter.setBrush(chart.theme.filling(series.role));
    const double half = half_bar(geometry, series, chart.layout.fonts.scale);
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const QPointF a = geometry.at(0.0, series.y[i] - half);
        const QPointF b = geometry.at(series.x[i], series.y[i] + half);
        const QRectF bar = QRectF(a, b).normalized().intersected(geometry.area);
        if (!bar.isEmpty()) painter.drawRect(bar);
    }
}

QColor cell_colour(const ChartDrawing& chart, double z) {
    const double low = chart.plot.z_low, high = chart.plot.z_high;
    if (low < 0.0 && high > 0.0) return chart.theme.diverging(z < 0.0 ? -z / low : z / high);
    return chart.theme.sequential((z - low) / (high - low));
}

/// Two significant digits of the largest value of the map; up to four where less would tell nothing apart.
std::string cell_text(const ChartDrawing& chart, double z) {
    const double low = chart.plot.z_low, high = chart.plot.z_high;
    const double largest = std::max(std::abs(low), std::abs(high));
    int decimals = decimals_for(largest == 1.0 ? 0.99 : largest, 2);
    if (low * high > 0.0 && high > low)
        decimals = std::max(decimals, std::min(decimals_for(high - low, 2), decimals_for(largest, 4)));
    return grouped_number(z, std::max(0, decimals), chart.theme.numbers());
}

void draw_heat_map(QPainter& painter, const ChartDrawing& chart, const PlotSeries& series) {
    const PlotGeometry& geometry = chart.layout.geometry;
    const std::size_t columns = chart.plot.x.categories.size();
    const QFont& font = chart.layout.fonts.figures;
    const double room = std::abs(geometry.x_at(1.0) - geometry.x_at(0.0));
    const bool with_text = text_width(cell_text(chart, -0.88 * chart.plot.z_high), font) + 4.0 < room;
    for (std::size_t i = 0; i < series.z.size(); ++i) {
        const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
        const QRectF cell = QRectF(geometry.at(column - 0.5, row - 0.5), geometry.at(column + 0.5, row + 0.5))
                                .intersected(geometry.area);
        if (cell.isEmpty() || !std::isfinite(series.z[i])) continue;
        const QColor colour = cell_colour(chart, series.z[i]);
        painter.setPen(room > 12.0 ? QPen(chart.theme.tokens().stage, 1.0) : QPen(colour, 0.3));
        painter.setBrush(colour);
        painter.drawRect(cell);
        const LabelText text(cell_text(chart, series.z[i]), font);
        if (!with_text || cell.width() < text.width() || cell.height() < text.height()) continue;
        painter.setPen(Theme::text_on(colour));
        text.draw(painter, cell.center() - QPointF(0.5 * text.width(), 0.5 * text.height()));
    }
}

/// Draws it from the top down, each colour over the end of the last: no seams.
void draw_colour_bar(QPainter& painter, const ChartDrawing& chart) {
    const QRectF& bar = chart.layout.colour_bar;
    if (bar.isEmpty()) return;
    constexpr int steps = 96;
    for (int i = 0; i < steps; ++i) {
        const double part = (i + 0.5) / steps;
        const double z = chart.plot.z_high + part * (chart.plot.z_low - chart.plot.z_high);
        painter.fillRect(bar.adjusted(0.0, i * bar.height() / steps, 0.0, 0.0), cell_colour(chart, z));
    }
}

void draw_axes(QPainter& painter, const ChartDrawing& chart) {
    if (has_heat_map(chart.plot)) return;
    const PlotGeometry& geometry = chart.layout.geometry;
    const QRectF& area = geometry.area;
    const bool zero_inside =
        chart.plot.horizontal_bars && geometry.view.x_low < 0.0 && geometry.view.x_high > 0.0;
    const double length = std::round(4.0 * chart.layout.fonts.scale);
    painter.setPen(QPen(chart.theme.tokens().line2, 1.0));
    const double bottom = sharp(area.bottom()), left = sharp(area.left());
    painter.drawLine(QPointF(left, bottom), QPointF(area.right(), bottom));
    if (!zero_inside) painter.drawLine(QPointF(left, area.top()), QPointF(left, bottom));
    for (const Tick& tick : chart.layout.x.ticks) {
        const double x = sharp(geometry.x_at(tick.at));
        painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + length));
    }
    for (const Tick& tick : chart.layout.y.ticks) {
        const double y = sharp(geometry.y_at(tick.at));
        painter.drawLine(QPointF(left - length, y), QPointF(left, y));
    }
    if (zero_inside) {
        const double zero = sharp(geometry.x_at(0.0));
        painter.drawLine(QPointF(zero, area.top()), QPointF(zero, bottom));
    }
}

void draw_marks(QPainter& painter, const ChartDrawing& chart) {
    const PlotGeometry& geometry = chart.layout.geometry;
    for (std::size_t i = 0; i < chart.plot.marks.size(); ++i) {
        const PlotMark& mark = chart.plot.marks[i];
        painter.setPen(QPen(chart.theme.series(mark.role), 1.0));
        if (mark.horizontal) {
            const double y = sharp(geometry.y_at(on_axis(chart.plot.y, mark.at)));
            if (y >= geometry.area.top() && y <= geometry.area.bottom() + 1.0)
                painter.drawLine(QPointF(geometry.area.left(), y), QPointF(geometry.area.right(), y));
        } else {
            const double x = sharp(geometry.x_at(on_axis(chart.plot.x, mark.at)));
            if (x >= geometry.area.left() && x <= geometry.area.right() + 1.0)
                painter.drawLine(QPointF(x, chart.layout.mark_tops[i]), QPointF(x, geometry.area.bottom()));
        }
    }
}

/// The value of each bar beside its end, clear of other series' points on the same row; of bars that share a
/// row only where the bars are as high as the text.
void draw_bar_values(QPainter& painter, const ChartDrawing& chart, const PlotSeries& bars) {
    const PlotGeometry& geometry = chart.layout.geometry;
    const bool alone = &bars == &chart.plot.series.front() &&
                       std::count_if(chart.plot.series.begin(), chart.plot.series.end(),
                                     [](const PlotSeries& s) { return s.kind == SeriesKind::bars; }) == 1;
    const double gap = std::round(6.0 * chart.layout.fonts.scale);
    const QRectF room = geometry.area.adjusted(0.0, -gap, 2.0 * gap, gap);
    painter.setPen(chart.theme.tokens().ink);
    for (std::size_t i = 0; i < bars.x.size(); ++i) {
        double low = std::min(0.0, bars.x[i]), high = std::max(0.0, bars.x[i]);
        for (const PlotSeries& series : chart.plot.series)
            for (std::size_t j = 0; j < series.x.size(); ++j)
                if (series.y[j] == bars.y[i]) {
                    low = std::min(low, series.x[j]);
                    high = std::max(high, series.x[j]);
                }
        const LabelText text(grouped_number(bars.x[i], 1, chart.theme.numbers()), chart.layout.fonts.figures);
        const double left =
            bars.x[i] < 0.0 ? geometry.x_at(low) - gap - text.width() : geometry.x_at(high) + gap;
        const QRectF box(left, geometry.y_at(bars.y[i]) - 0.5 * text.height(), text.width(), text.height());
        const double cell =
            std::abs(geometry.y_at(1.0) - geometry.y_at(0.0)) * (alone ? 1.0 : bars.bar_width);
        if (cell >= 0.8 * text.height() && room.contains(box)) text.draw(painter, box.topLeft());
    }
}

void draw_swatch(QPainter& painter, const ChartDrawing& chart, const LegendEntry& entry) {
    const double middle = entry.swatch.center().y(), unit = chart.layout.fonts.scale;
    const QRectF patch(entry.swatch.left(), middle - 4.5 * unit, entry.swatch.width(), 9.0 * unit);
    painter.setPen(Qt::NoPen);
    switch (entry.kind) {
        case SwatchKind::filling:
            painter.fillRect(patch, chart.theme.filling(entry.role));
            break;
        case SwatchKind::band:
            // small and beside no ground of its own: stronger than the band
            painter.fillRect(patch, mix(chart.theme.tokens().hover, chart.theme.series(entry.role), 0.35));
            painter.setPen(QPen(chart.theme.series(entry.role), 1.0));
            painter.drawLine(patch.topLeft(), patch.bottomLeft());
            painter.drawLine(patch.topRight(), patch.bottomRight());
            break;
        case SwatchKind::points:
            painter.setBrush(chart.theme.series(entry.role));
            painter.drawEllipse(entry.swatch.center(), 2.7 * unit, 2.7 * unit);
            break;
        case SwatchKind::line:
            painter.setPen(pen_of(entry.role, chart.theme, unit));
            painter.drawLine(QPointF(patch.left(), middle), QPointF(patch.right(), middle));
            break;
        case SwatchKind::mark:
            painter.setPen(QPen(chart.theme.series(entry.role), 1.0));
            painter.drawLine(QPointF(patch.left(), sharp(middle)), QPointF(patch.right(), sharp(middle)));
            break;
    }
}

void draw_text(QPainter& painter, const ChartDrawing& chart, const PlacedText& text) {
    const bool quiet = text.kind == TextKind::axis_title || text.kind == TextKind::message;
    painter.setPen(quiet ? chart.theme.tokens().ink2 : chart.theme.tokens().ink);
    const LabelText label(text.text, font_of(chart.layout.fonts, text.kind));
    if (!text.upwards) return label.draw(painter, text.box.topLeft());
    painter.save();
    painter.translate(text.box.bottomLeft());
    painter.rotate(-90.0);
    label.draw(painter, {});
    painter.restore();
}

}  // namespace

QPen pen_of(SeriesRole role, const Theme& theme, double scale) {
    const double width = role == SeriesRole::reference || role == SeriesRole::emphasis ? 1.0 : 1.6;
    QPen pen(theme.series(role), width * std::max(scale, 0.85), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (role == SeriesRole::first_order) pen.setDashPattern({5.0, 3.0});
    return pen;
}

void draw_below(QPainter& painter, const ChartDrawing& chart, const QRectF& ground) {
    painter.fillRect(ground, chart.theme.tokens().stage);
    if (chart.plot.series.empty()) return;
    draw_bands(painter, chart);
    if (!has_heat_map(chart.plot)) draw_grid(painter, chart);
    for (const PlotSeries& series : chart.plot.series) {
        if (series.kind == SeriesKind::heat_map) draw_heat_map(painter, chart, series);
        if (series.kind != SeriesKind::bars) continue;
        if (chart.plot.horizontal_bars)
            draw_horizontal_bars(painter, chart, series);
        else
            draw_histogram(painter, chart, series);
    }
}

void draw_above(QPainter& painter, const ChartDrawing& chart) {
    draw_colour_bar(painter, chart);
    if (!chart.plot.series.empty()) {
        draw_axes(painter, chart);
        draw_marks(painter, chart);
        for (const PlotSeries& series : chart.plot.series)
            if (chart.plot.horizontal_bars && series.kind == SeriesKind::bars)
                draw_bar_values(painter, chart, series);
    }
    for (const LegendEntry& entry : chart.layout.legend) draw_swatch(painter, chart, entry);
    for (const PlacedText& text : chart.layout.texts) draw_text(painter, chart, text);
}

}  // namespace covaria::ui
