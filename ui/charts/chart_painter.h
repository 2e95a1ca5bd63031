// Charts as pictures: on any painter (PDF, SVG: vectors), and as SVG and PNG files. Needs a QApplication, but
// no display.
#pragma once

#include <QImage>
#include <QRectF>
#include <QSize>
#include <string>

#include "core/base/error.h"
#include "core/report/plot_specification.h"
#include "ui/charts/plot_geometry.h"
#include "ui/theme/theme.h"

class QChart;
class QPainter;

namespace covaria::ui {

/// The caller owns it, or the scene that it is added to.
QChart* make_chart(const PlotSpecification& plot, const Theme& theme);

/// Draws the chart into `area` of the painter, as vectors. Sizes of texts follow the resolution of the paint
/// device (7.5 to 9 pt); units of an SVG or a QPicture count as 1/96 inch. `view` shows a part of the data.
void paint_plot(QPainter& painter, const QRectF& area, const PlotSpecification& plot, const Theme& theme);
void paint_plot(QPainter& painter, const QRectF& area, const PlotSpecification& plot, const Theme& theme,
                const PlotView& view);

/// `size` in units of 1/96 inch; the image has `pixel_ratio` pixels per unit.
QImage plot_image(const PlotSpecification& plot, const Theme& theme, QSize size, double pixel_ratio = 1.0);

/// Errors: io (the message names the file).
Result<void> write_svg(const std::string& file, const PlotSpecification& plot, const Theme& theme,
                       QSize size);
Result<void> write_png(const std::string& file, const PlotSpecification& plot, const Theme& theme, QSize size,
                       double pixel_ratio = 2.0);

}  // namespace covaria::ui
