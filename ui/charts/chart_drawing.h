// Draws what Qt Charts does not: ground, bands, bars and maps below the series; axes, marks and texts above.
#pragma once

#include "ui/charts/chart_layout.h"
#include "ui/theme/theme.h"

class QPainter;
class QPen;

namespace covaria::ui {

struct ChartDrawing {
    const PlotSpecification& plot;
    const ChartLayout& layout;
    const Theme& theme;
};

void draw_below(QPainter& painter, const ChartDrawing& chart, const QRectF& ground);
void draw_above(QPainter& painter, const ChartDrawing& chart);
/// Line of a series: its role is told by colour and dashes.
QPen pen_of(SeriesRole role, const Theme& theme, double scale);

}  // namespace covaria::ui
