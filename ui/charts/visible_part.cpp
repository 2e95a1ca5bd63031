// The data inside a view.
#include "ui/charts/visible_part.h"

#include <algorithm>

namespace covaria::ui {
namespace {

/// The part of the segment from a to b inside the view, as parameters; empty (begin > end) if there is none:
/// Y.-D. Liang, B. A. Barsky, ACM Trans. Graphics 3 (1984) 1-22.
struct Part {
    double begin = 0.0, end = 1.0;
    void keep(double from, double by, double low, double high) {
        if (by == 0.0) {
            if (from < low || from > high) end = -1.0;
            return;
        }
        const auto [first, last] = std::minmax({(low - from) / by, (high - from) / by});
        begin = std::max(begin, first);
        end = std::min(end, last);
    }
};

QPointF point(const PlotSpecification& plot, const PlotSeries& series, std::size_t i) {
    // Beyond every axis; the way between two such places is a number.
    constexpr double outside = 1e305;
    return {std::clamp(on_axis(plot.x, series.x[i]), -outside, outside),
            std::clamp(on_axis(plot.y, series.y[i]), -outside, outside)};
}

void append(PlotSeries& series, const PlotSpecification& plot, QPointF place) {
    series.x.push_back(from_axis(plot.x, place.x()));
    series.y.push_back(from_axis(plot.y, place.y()));
}

PlotSeries without_data(const PlotSeries& series) {
    PlotSeries empty = series;
    empty.x.clear();
    empty.y.clear();
    return empty;
}

std::vector<PlotSeries> cut_line(const PlotSpecification& plot, const PlotSeries& line,
                                 const PlotView& view) {
    std::vector<PlotSeries> runs;
    bool inside = false;
    for (std::size_t i = 0; i + 1 < line.x.size(); ++i) {
        const QPointF a = point(plot, line, i), by = point(plot, line, i + 1) - a;
        Part part;
        part.keep(a.x(), by.x(), view.x_low, view.x_high);
        part.keep(a.y(), by.y(), view.y_low, view.y_high);
        if (part.begin >= part.end) {
            inside = false;
            continue;
        }
        if (!inside || part.begin > 0.0) {
            runs.push_back(without_data(line));
            append(runs.back(), plot, a + part.begin * by);
        }
        append(runs.back(), plot, a + part.end * by);
        inside = part.end >= 1.0;
    }
    if (runs.empty()) runs.push_back(without_data(line));
    for (std::size_t i = 1; i < runs.size(); ++i) runs[i].name = {};
    return runs;
}

PlotSeries points_inside(const PlotSpecification& plot, const PlotSeries& points, const PlotView& view) {
    PlotSeries kept = without_data(points);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        const QPointF p = point(plot, points, i);
        if (p.x() >= view.x_low && p.x() <= view.x_high && p.y() >= view.y_low && p.y() <= view.y_high)
            append(kept, plot, p);
    }
    return kept;
}

}  // namespace

PlotSpecification visible_part(const PlotSpecification& plot, const PlotView& view) {
    PlotSpecification part = plot;
    part.series.clear();
    for (const PlotSeries& series : plot.series) {
        if (series.kind == SeriesKind::line)
            for (PlotSeries& run : cut_line(plot, series, view)) part.series.push_back(std::move(run));
        else if (series.kind == SeriesKind::points)
            part.series.push_back(points_inside(plot, series, view));
        else
            part.series.push_back(series);
    }
    return part;
}

}  // namespace covaria::ui
