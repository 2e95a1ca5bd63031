// Charts as pictures.
#include "ui/charts/chart_painter.h"

#include <QBuffer>
#include <QGraphicsScene>
#include <QPaintEngine>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>

#include "core/base/printable.h"
#include "core/result_files/csv_writer.h"
#include "core/views/plots.h"
#include "ui/charts/plot_chart.h"
#include "ui/charts/visible_part.h"

namespace covaria::ui {
namespace {

/// Device units per 1/96 inch.
double units_of(const QPainter& painter) {
    if (painter.paintEngine()->type() == QPaintEngine::SVG) return 1.0;
    return painter.device()->logicalDpiX() / 96.0;
}

Result<void> save(const std::string& file, const QByteArray& bytes) {
    QSaveFile target(QString::fromStdString(file));
    if (target.open(QIODevice::WriteOnly) && target.write(bytes) == bytes.size() && target.commit())
        return {};
    return fail(ErrorCode::io, "cannot write " + file + ": " + target.errorString().toStdString());
}

}  // namespace

QChart* make_chart(const PlotSpecification& plot, const Theme& theme) {
    return new PlotChart(plot, theme);
}

void paint_plot(QPainter& painter, const QRectF& area, const PlotSpecification& plot, const Theme& theme,
                const std::optional<PlotView>& view) {
    const QSizeF size = area.size() / units_of(painter);
    const bool cuts = painter.paintEngine()->type() != QPaintEngine::SVG;
    QGraphicsScene scene;
    auto* chart = new PlotChart(view && !cuts ? visible_part(plot, *view) : plot, theme);
    scene.addItem(chart);
    chart->resize(size);
    chart->set_view(view.value_or(whole_view(plot)));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter, area, QRectF(QPointF(), size), Qt::IgnoreAspectRatio);
    painter.restore();
}

QImage plot_image(const ShownPlot& shown, double pixel_ratio) {
    QImage image(shown.size * pixel_ratio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixel_ratio);
    image.fill(shown.theme.tokens().stage);
    QPainter painter(&image);
    paint_plot(painter, QRectF(QPointF(), QSizeF(shown.size)), shown.plot, shown.theme, shown.view);
    return image;
}

std::string svg_bytes(const std::string& title, QSize size,
                      const std::function<void(QPainter&, const QRectF&)>& paint) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(96);  // else what is painted fills three quarters of the frame
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(QString::fromStdString(title));
    QPainter painter(&generator);
    paint(painter, QRectF(QPointF(), QSizeF(size)));
    painter.end();
    return printable(bytes.toStdString());  // XML has no place for control characters
}

Result<void> write_svg(const std::string& file, const ShownPlot& shown) {
    const std::string bytes =
        svg_bytes(to_unicode(shown.plot.title), shown.size, [&shown](QPainter& painter, const QRectF& area) {
            paint_plot(painter, area, shown.plot, shown.theme, shown.view);
        });
    return save(file, QByteArray::fromStdString(bytes));
}

Result<void> write_png(const std::string& file, const ShownPlot& shown, double pixel_ratio) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!plot_image(shown, pixel_ratio).save(&buffer, "PNG"))
        return fail(ErrorCode::io, "cannot make a picture of " + std::to_string(shown.size.width()) + " x " +
                                       std::to_string(shown.size.height()) + " for " + file);
    return save(file, bytes);
}

Result<void> write_csv(const std::string& file, const PlotSpecification& plot) {
    return save(file, QByteArray::fromStdString(plot_csv(plot)));
}

}  // namespace covaria::ui
