// The report as PDF: real text and tables, vector charts, pictures of scenes.
#include "ui/print/pdf_report.h"

#include <QBuffer>
#include <QFontDatabase>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>
#include <optional>

#include "core/base/file_io.h"
#include "core/base/version.h"
#include "ui/print/report_pages.h"

namespace covaria::ui {
namespace {

template <class Block>
bool has(const ReportDocument& document) {
    return std::any_of(document.blocks.begin(), document.blocks.end(),
                       [](const ReportBlock& block) { return std::holds_alternative<Block>(block); });
}

/// Letters of a language that are not in every font.
std::optional<QFontDatabase::WritingSystem> letters_of(const std::string& language) {
    if (language == "zh_CN") return QFontDatabase::SimplifiedChinese;
    if (language == "ko") return QFontDatabase::Korean;
    return std::nullopt;
}

Result<void> check_letters(const ReportDocument& document) {
    if (const auto letters = letters_of(document.language);
        letters && QFontDatabase::families(*letters).isEmpty())
        return fail(ErrorCode::io, "no font of this system has the letters of the document's language, " +
                                       document.language + " (Debian: install fonts-noto-cjk)");
    return {};
}

Result<void> check_painters(const ReportDocument& document, const PdfOptions& options) {
    if (has<PlotBlock>(document) && !options.paint_plot)
        return fail(ErrorCode::usage, "the report has charts, but nothing to paint them with was given");
    if (has<SceneBlock>(document) && !options.render_scene)
        return fail(ErrorCode::usage, "the report has pictures, but nothing to draw them with was given");
    return {};
}

void set_up(QPdfWriter& writer, const ReportDocument& document, PaperSize paper) {
    writer.setResolution(printed_dots_per_inch);
    writer.setPageSize(page_size_of(paper));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0), QPageLayout::Millimeter);
    writer.setTitle(QString::fromStdString(document.title));
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);  // fonts embedded, colours defined
}

}  // namespace

Result<std::string> pdf_bytes(const ReportDocument& document, const PdfOptions& options) {
    if (auto checked = check_painters(document, options); !checked) return fail(checked.error());
    if (auto checked = check_letters(document); !checked) return fail(checked.error());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    set_up(writer, document, options.paper);
    const ReportPages pages(document, options, &writer);
    QPainter painter;
    if (!painter.begin(&writer)) return fail(ErrorCode::io, "the PDF of the report could not be begun");
    for (int page = 0; page < pages.count(); ++page) {
        if (page > 0) writer.newPage();
        pages.paint(page, painter);
    }
    if (!painter.end()) return fail(ErrorCode::io, "the PDF of the report could not be finished");
    return archived_pdf(
        buffer.data().toStdString(),
        {document.title, std::string("Covaria ") + version(), document.author, document.language},
        options.attached, {pages.bookmarks(), pages.links()});
}

Result<void> write_pdf(const ReportDocument& document, const PdfOptions& options,
                       const std::filesystem::path& file) {
    const auto bytes = pdf_bytes(document, options);
    if (!bytes) return fail(bytes.error());
    return write_file_atomically(file, *bytes);
}

}  // namespace covaria::ui
