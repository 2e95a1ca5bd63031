#include "app/report_files.h"

#include "app/application.h"
#include "ui/export/report_export.h"
#include "ui/export/report_maker.h"

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
    ui::ScenePictures scenes(source.analyses);
    const ui::FigurePainters painters = ui::report_painters(scenes);
    ui::ReportTarget target;
    target.folder = files.folder;
    target.formats = formats_of(files.formats);
    target.paper = files.paper == "letter" ? ui::PaperSize::letter : ui::PaperSize::a4;
    auto written =
        ui::export_report(build_report(source.made, source.analyses, source.failed), target, painters, stop);
    if (!written && !scenes.problem().empty()) written.error().message += ": " + scenes.problem();
    return written;
}

}  // namespace covaria
