// Charts as pictures: on any painter (PDF, SVG: vectors), and as files. Needs a QApplication, but no display.
#pragma once

#include <QImage>
#include <QRectF>
#include <QSize>
#include <functional>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "ui/charts/plot_geometry.h"
#include "ui/theme/theme.h"

class QChart;
class QPainter;

namespace covaria::ui {

/// The caller owns the chart, or the scene that it is added to.
QChart* make_chart(const PlotSpecification& plot, const Theme& theme);

/// Draws the chart into `area` of the painter, as vectors. Sizes of texts follow the resolution of the paint
/// device (7.5 to 9 pt); units of an SVG count as 1/96 inch. `view`: a part of the data.
void paint_plot(QPainter& painter, const QRectF& area, const PlotSpecification& plot, const Theme& theme,
                const std::optional<PlotView>& view = {});

/// A plot as it is shown somewhere; `size` in units of 1/96 inch.
struct ShownPlot {
    const PlotSpecification& plot;
    const Theme& theme;
    QSize size{720, 440};
    std::optional<PlotView> view = {};  ///< empty: all of the data
};

/// `pixel_ratio`: pixels per unit of the size.
QImage plot_image(const ShownPlot& shown, double pixel_ratio = 1.0);

/// A picture of that size (in units of 1/96 inch) as SVG text.
std::string svg_bytes(const std::string& title, QSize size,
                      const std::function<void(QPainter&, const QRectF&)>& paint);

// Errors of the writers: io; the message names the file.
Result<void> write_svg(const std::string& file, const ShownPlot& shown);
Result<void> write_png(const std::string& file, const ShownPlot& shown, double pixel_ratio = 2.0);
Result<void> write_csv(const std::string& file, const PlotSpecification& plot);

}  // namespace covaria::ui
