// The part of the data that a chart shows, and the place of a value on it.
#pragma once

#include <QPointF>
#include <QRectF>

#include "core/text/plot_specification.h"

namespace covaria::ui {

/// The range of both axes; of a logarithmic axis, log10 of the values.
struct PlotView {
    double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 1.0;
    bool operator==(const PlotView&) const = default;
};

/// The view of all data, with margins, or of what the specification's axes ask for.
PlotView whole_view(const PlotSpecification& plot);
bool has_heat_map(const PlotSpecification& plot);
/// Coordinate on the axis: log10 of the value where the axis is logarithmic.
double on_axis(const PlotAxis& axis, double value);
double from_axis(const PlotAxis& axis, double coordinate);

/// Maps axis coordinates to the plot area and back. Categories run downwards.
struct PlotGeometry {
    QRectF area;
    PlotView view;
    bool y_down = false;

    double x_at(double coordinate) const;
    double y_at(double coordinate) const;
    QPointF at(double x, double y) const { return {x_at(x), y_at(y)}; }
    QPointF coordinates_at(QPointF place) const;
};

/// Half the thickness of horizontal bars, in coordinates of their axis: few bars are not as thick as blocks.
/// `scale` is that of the chart's fonts.
double half_bar(const PlotGeometry& geometry, const PlotSeries& bars, double scale);

}  // namespace covaria::ui
