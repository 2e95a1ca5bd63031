// The report as PDF/A-3b: real text and tables, vector charts, pictures of scenes, and the files it carries.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/document/report_document.h"
#include "core/pdf/pdf_archive.h"
#include "ui/print/figure_layout.h"
#include "ui/print/page_style.h"

namespace covaria::ui {

struct PdfOptions {
    PaperSize paper = PaperSize::a4;
    PaintPlot paint_plot = {};      ///< needed if the document has charts
    RenderScene render_scene = {};  ///< needed if the document has pictures
    std::string foot = {};          ///< at the foot of every page, such as the date of issue
    std::vector<AttachedFile> attached = {};
};

/// The bytes of the PDF, equal for equal arguments. Needs a QGuiApplication. Error{usage}: charts or pictures
/// without their painter.
Result<std::string> pdf_bytes(const ReportDocument& document, const PdfOptions& options);
/// Writes atomically: the whole file or none.
Result<void> write_pdf(const ReportDocument& document, const PdfOptions& options,
                       const std::filesystem::path& file);

}  // namespace covaria::ui
