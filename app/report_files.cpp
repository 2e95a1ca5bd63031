#include "app/report_files.h"

#include <algorithm>
#include <filesystem>

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

ui::ReportTarget target_of(const ReportFiles& files) {
    ui::ReportTarget target;
    target.folder = files.folder;
    target.name = files.name;
    target.formats = formats_of(files.formats);
    target.paper = files.paper == "letter" ? ui::PaperSize::letter : ui::PaperSize::a4;
    return target;
}

}  // namespace

Result<void> write_into_one_file(const std::string& file, ReportFiles& files) {
    const std::filesystem::path path(file);
    const std::string ending = path.extension().string();
    if (path.stem().empty() || (ending != ".pdf" && ending != ".html" && ending != ".md"))
        return fail(ErrorCode::usage, "the name '" + file + "' must end in .pdf, .html or .md");
    files.folder = path.has_parent_path() ? path.parent_path().string() : ".";
    files.name = path.stem().string();
    files.formats = {ending == ".md" ? "markdown" : ending.substr(1)};
    return {};
}

Result<void> write_document(const ReportDocument& document, const ReportFiles& files,
                            const std::stop_token& stop) {
    const auto application = make_application(Platform::offscreen);
    return ui::export_report(document, target_of(files), {}, stop);
}

Result<void> write_document(const ReportDocument& document, const ReportSource& source,
                            const ReportFiles& files, const std::stop_token& stop) {
    const auto application = make_application(Platform::offscreen);
    ui::ScenePictures scenes(source);
    const ui::FigurePainters painters = ui::report_painters(scenes);
    ui::ReportTarget target = target_of(files);
    if (std::find(target.formats.begin(), target.formats.end(), ui::ReportFormat::pdf) !=
        target.formats.end())
        target.attached = report_data(source);
    auto written = ui::export_report(document, target, painters, stop);
    if (!written && !scenes.problem().empty()) written.error().message += ": " + scenes.problem();
    return written;
}

}  // namespace covaria
