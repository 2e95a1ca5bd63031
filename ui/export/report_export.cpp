#include "ui/export/report_export.h"

#include <QBuffer>
#include <algorithm>

#include "core/document/document_writers.h"
#include "core/project/project_file.h"
#include "ui/charts/chart_painter.h"
#include "ui/print/pdf_report.h"

namespace covaria::ui {
namespace {

constexpr QSize plot_size(640, 400);
constexpr QSize scene_size(1600, 1000);

Result<std::string> png_bytes(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) return fail(ErrorCode::io, "a picture could not be encoded as PNG");
    return bytes.toStdString();
}

/// Writes one block's figure, if it is one.
struct FigureWriter {
    const std::filesystem::path& folder;
    const FigurePainters& painters;
    const std::stop_token& stop;

    Result<void> operator()(const PlotBlock& block) const {
        const auto svg = svg_bytes(
            to_unicode(block.plot.title), plot_size,
            [&](QPainter& painter, const QRectF& area) { painters.paint_plot(painter, area, block.plot); });
        if (stop.stop_requested()) return {};  // the chart may be empty; the next block says so
        return write_file_atomically(folder / (block.plot.id + ".svg"), svg);
    }
    Result<void> operator()(const SceneBlock& block) const {
        const QImage image = painters.render_scene(block, scene_size);
        if (image.isNull())
            return fail(ErrorCode::numeric,
                        "the scene of analysis \"" + block.analysis + "\" could not be drawn");
        const auto bytes = png_bytes(image);
        if (!bytes) return fail(bytes.error());
        return write_file_atomically(folder / (block.id + ".png"), *bytes);
    }
    template <class Other>
    Result<void> operator()(const Other&) const {
        return {};
    }
};

Result<void> write_figures(const ReportDocument& document, const std::filesystem::path& folder,
                           const FigurePainters& painters, const std::stop_token& stop) {
    for (const ReportBlock& block : document.blocks) {
        if (stop.stop_requested())
            return fail(ErrorCode::cancelled, "stopped while drawing the report's figures");
        if (auto written = std::visit(FigureWriter{folder, painters, stop}, block); !written) return written;
    }
    if (stop.stop_requested())
        return fail(ErrorCode::cancelled, "stopped while drawing the report's figures");
    return {};
}

Result<void> export_format(const ReportDocument& document, const ReportTarget& target,
                           const FigurePainters& painters, ReportFormat format, const std::stop_token& stop) {
    const std::filesystem::path stem = target.folder / target.name;
    switch (format) {
        case ReportFormat::pdf: {
            const auto bytes = pdf_bytes(document, {target.paper, painters.paint_plot, painters.render_scene,
                                                    target.foot, target.attached});
            if (!bytes) return fail(bytes.error());
            if (stop.stop_requested()) return fail(ErrorCode::cancelled, "stopped while writing the report");
            return write_file_atomically(stem.string() + ".pdf", *bytes);
        }
        case ReportFormat::html:
            return write_file_atomically(stem.string() + ".html", to_html(document));
        case ReportFormat::markdown:
            return write_file_atomically(stem.string() + ".md", to_markdown(document));
    }
    return {};
}

}  // namespace

Result<void> export_report(const ReportDocument& document, const ReportTarget& target,
                           const FigurePainters& painters, const std::stop_token& stop) {
    const auto beside_figures = [](ReportFormat format) { return format != ReportFormat::pdf; };
    if (std::any_of(target.formats.begin(), target.formats.end(), beside_figures))
        if (auto written = write_figures(document, target.folder, painters, stop); !written) return written;
    for (ReportFormat format : target.formats) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "stopped while writing the report");
        if (auto written = export_format(document, target, painters, format, stop); !written) return written;
    }
    return {};
}

}  // namespace covaria::ui
