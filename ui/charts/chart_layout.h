// The place of every part of a chart: plot area, ticks, texts, legend. Pure, so that tests can ask whether
// texts collide.
#pragma once

#include <QFont>
#include <vector>

#include "core/text/numbers.h"
#include "core/text/ticks.h"
#include "ui/charts/plot_geometry.h"

namespace covaria::ui {

/// Fonts by the chart's width: a chart 80 mm wide (about 300 units of 1/96 inch) still has 7.5 pt.
struct ChartFonts {
    QFont title, label, figures;
    double scale = 1.0;  ///< scales line widths and distances; 1 in the largest chart
};
ChartFonts fonts_for(double width);

enum class TextKind { title, label, axis_title, figures, message };

struct PlacedText {
    Text text;
    QRectF box;
    TextKind kind = TextKind::label;
    bool upwards = false;  ///< turned by 90 degrees, read from the right
};

enum class SwatchKind { filling, line, points, band, mark };

struct LegendEntry {
    QRectF swatch;
    SwatchKind kind = SwatchKind::line;
    SeriesRole role = SeriesRole::data;
};

struct ChartLayout {
    ChartFonts fonts;
    PlotGeometry geometry;
    Ticks x, y;
    std::vector<PlacedText> texts;
    std::vector<LegendEntry> legend;
    std::vector<double>
        mark_tops;      ///< per mark: where its line begins, above the plot area for labelled ones
    QRectF colour_bar;  ///< empty except for a heat map
};

/// Lengths in units of 1/96 inch. A specification without series gives its title as a message in the middle.
ChartLayout layout_chart(const PlotSpecification& plot, const QSizeF& size, const PlotView& view,
                         const NumberLocale& numbers = {});
const QFont& font_of(const ChartFonts& fonts, TextKind kind);

}  // namespace covaria::ui
