// Ranges of axes and the mapping to the plot area.
#include "ui/charts/plot_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace covaria::ui {
namespace {

// Axes end here: the range of one that reaches from the smallest double to the largest is none.
constexpr double farthest = 1e300;

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void include(double value) {
        if (!std::isfinite(value)) return;
        value = std::clamp(value, -farthest, farthest);
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

void widen(Range& range, double margin) {
    if (!(range.low <= range.high)) range = {0.0, 1.0};
    double by = margin * (range.high - range.low);
    if (!(range.high > range.low)) by = range.low == 0.0 ? 1.0 : 0.1 * std::abs(range.low);
    range.low -= by;
    range.high += by;
    if (!(range.high > range.low)) range.high = range.low + std::numeric_limits<double>::min();
}

/// Bars stand on zero; there is no room below it unless values need it. Negative values are wider by their
/// sign.
void stand_on_zero(Range& range, double margin) {
    range.include(0.0);
    const double size = range.high - range.low > 0.0 ? range.high - range.low : 1.0;
    if (range.low < 0.0) range.low -= 1.4 * margin * size;
    if (range.high > 0.0 || range.low == 0.0) range.high += margin * size;
}

bool has_bars(const PlotSpecification& plot) {
    return std::any_of(plot.series.begin(), plot.series.end(),
                       [](const PlotSeries& series) { return series.kind == SeriesKind::bars; });
}

Range x_range(const PlotSpecification& plot) {
    Range range;
    for (const PlotSeries& series : plot.series) {
        const double half =
            series.kind == SeriesKind::bars && !plot.horizontal_bars ? 0.5 * series.bar_width : 0.0;
        for (const double x : series.x) {
            range.include(on_axis(plot.x, x - half));
            range.include(on_axis(plot.x, x + half));
        }
    }
    for (const PlotMark& mark : plot.marks)
        if (!mark.horizontal) range.include(on_axis(plot.x, mark.at));
    if (plot.horizontal_bars)
        stand_on_zero(range, 0.18);
    else
        widen(range, 0.02);
    return range;
}

Range y_range(const PlotSpecification& plot) {
    Range range;
    for (const PlotSeries& series : plot.series)
        for (const double y : series.y) range.include(on_axis(plot.y, y));
    for (const PlotMark& mark : plot.marks)
        if (mark.horizontal) range.include(on_axis(plot.y, mark.at));
    if (has_bars(plot))
        stand_on_zero(range, 0.05);
    else
        widen(range, 0.06);
    return range;
}

Range range_of(const PlotAxis& axis, Range from_data) {
    if (!axis.categories.empty()) return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
    if (!(axis.high > axis.low)) return from_data;
    Range stated;
    stated.include(on_axis(axis, axis.low));
    stated.include(on_axis(axis, axis.high));
    return stated.high > stated.low ? stated : from_data;
}

/// Part of the way from one end of an axis to the other, limited far outside: painters can compute with
/// places there.
double part_of(double coordinate, double low, double high) {
    constexpr double far_outside = 1e5;
    return std::clamp((coordinate - low) / (high - low), -far_outside, far_outside);
}

}  // namespace

PlotView whole_view(const PlotSpecification& plot) {
    const Range x = range_of(plot.x, x_range(plot)), y = range_of(plot.y, y_range(plot));
    return {x.low, x.high, y.low, y.high};
}

bool has_heat_map(const PlotSpecification& plot) {
    return std::any_of(plot.series.begin(), plot.series.end(),
                       [](const PlotSeries& series) { return series.kind == SeriesKind::heat_map; });
}

double on_axis(const PlotAxis& axis, double value) {
    return axis.logarithmic ? std::log10(value) : value;
}

double from_axis(const PlotAxis& axis, double coordinate) {
    return axis.logarithmic ? std::pow(10.0, coordinate) : coordinate;
}

double PlotGeometry::x_at(double coordinate) const {
    return area.left() + area.width() * part_of(coordinate, view.x_low, view.x_high);
}

double PlotGeometry::y_at(double coordinate) const {
    const double part = part_of(coordinate, view.y_low, view.y_high);
    return y_down ? area.top() + area.height() * part : area.bottom() - area.height() * part;
}

QPointF PlotGeometry::coordinates_at(QPointF place) const {
    const double x = (place.x() - area.left()) / area.width();
    const double down = (place.y() - area.top()) / area.height();
    const double y = y_down ? down : 1.0 - down;
    return {view.x_low + x * (view.x_high - view.x_low), view.y_low + y * (view.y_high - view.y_low)};
}

double half_bar(const PlotGeometry& geometry, const PlotSeries& bars, double scale) {
    constexpr double thickest = 40.0;
    const double row = std::abs(geometry.y_at(1.0) - geometry.y_at(0.0));
    return 0.5 * std::min(bars.bar_width, thickest * scale / row);
}

}  // namespace covaria::ui
