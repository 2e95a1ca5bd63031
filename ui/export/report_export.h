// A report as files: PDF, HTML and Markdown with their figures beside them. Used by the command line and the
// window.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/report_document.h"
#include "core/pdf/pdf_archive.h"
#include "ui/print/page_style.h"
#include "ui/print/report_layout.h"

namespace covaria::ui {

enum class ReportFormat { pdf, html, markdown };

struct ReportTarget {
    std::filesystem::path folder;
    std::string name = "report";  ///< name of the files, without ending
    std::vector<ReportFormat> formats = {ReportFormat::pdf, ReportFormat::html, ReportFormat::markdown};
    PaperSize paper = PaperSize::a4;
    std::string foot = {};                    ///< at the foot of every PDF page
    std::vector<AttachedFile> attached = {};  ///< attached to the PDF
};

/// Every file is written whole or not at all. HTML and Markdown bring their figures: charts as SVG, scenes as
/// PNG. Errors: io, cancelled (between figures), numeric (a scene cannot be drawn: `render_scene` gave a null
/// image).
Result<void> export_report(const ReportDocument& document, const ReportTarget& target,
                           const FigurePainters& painters, const std::stop_token& stop = {});

}  // namespace covaria::ui
