#include "app/report_files.h"

#include <QApplication>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "ui/charts/chart_painter.h"
#include "ui/export/report_export.h"
#include "ui/export/scene_pictures.h"
#include "ui/theme/theme.h"

namespace covaria {
namespace {

/// Charts and fonts need an application object, but no display.
std::unique_ptr<QApplication> headless_application() {
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    setenv("XDG_RUNTIME_DIR", std::filesystem::temp_directory_path().c_str(), 0);  // else Qt complains on the terminal
    static int argc = 1;
    static char name[] = "covaria";
    static char* argv[] = {name, nullptr};
    return std::make_unique<QApplication>(argc, argv);
}

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
    const auto application = headless_application();
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
