#include "app/report_files.h"

#include "app/application.h"
#include "ui/charts/chart_painter.h"
#include "ui/export/report_export.h"
#include "ui/export/scene_pictures.h"
#include "ui/theme/theme.h"

namespace covaria {
namespace {

std::vector<ui::ReportFormat> formats_of(const std::vector<std::string>& names) {
    if (names.empty()) return {ui::ReportFormat::pdf, ui::ReportFormat::html, ui::ReportFormat::markdown};
    std::vector<ui::ReportFormat> formats;
    for (const std::string& name : names)
        formats.push_back(name == "pdf"    ? ui::ReportFormat::pdf
                          : name == "html" ? ui::ReportFormat::html
                                           : ui::ReportFormat::markdown);
    return formats;
}

}  // namespace

Result<void> write_reports(const ReportSource& source, const ReportFiles& files,
                           const std::stop_token& stop) {
    const auto application = make_application(Platform::offscreen);
    const ui::Theme theme = ui::Theme::light();
    ui::ScenePictures scenes(source.analyses);
    ui::FigurePainters painters;
    painters.paint_plot = [&](QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
        ui::paint_plot(painter, area, plot, theme);
    };
    painters.render_scene = [&](const SceneBlock& block, QSize size) { return scenes.render(block, size); };
    ui::ReportTarget target;
    target.folder = files.folder;
    target.formats = formats_of(files.formats);
    target.paper = files.paper == "letter" ? ui::PaperSize::letter : ui::PaperSize::a4;
    auto written = ui::export_report(build_report(source.project, source.assets, source.analyses), target,
                                     painters, stop);
    if (!written && !scenes.problem().empty()) written.error().message += ": " + scenes.problem();
    return written;
}

}  // namespace covaria
