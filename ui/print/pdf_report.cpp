// The report as PDF: real text and tables, vector charts, pictures of scenes.
#include "ui/print/pdf_report.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>

#include "core/project/project_file.h"
#include "core/report/table_text.h"
#include "ui/print/report_layout.h"
#include "ui/print/rich_text.h"

namespace covaria::ui {
namespace {

constexpr int dots_per_inch = 1200;

template <class Block>
bool has(const ReportDocument& document) {
    return std::any_of(document.blocks.begin(), document.blocks.end(),
                       [](const ReportBlock& block) { return std::holds_alternative<Block>(block); });
}

Result<void> check_painters(const ReportDocument& document, const PdfOptions& options) {
    if (has<PlotBlock>(document) && !options.paint_plot)
        return fail(ErrorCode::usage, "the report has charts, but nothing to paint them with was given");
    if (has<SceneBlock>(document) && !options.render_scene)
        return fail(ErrorCode::usage, "the report has pictures, but nothing to draw them with was given");
    return {};
}

void set_up(QPdfWriter& writer, const ReportDocument& document, PaperSize paper) {
    writer.setResolution(dots_per_inch);
    writer.setPageSize(page_size_of(paper));
    writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0), QPageLayout::Millimeter);
    writer.setTitle(QString::fromStdString(document.title));
    writer.setCreator("Covaria " COVARIA_VERSION);
}

/// Running head (project on the left, page of pages on the right) and foot of a page.
class PageFrame {
public:
    PageFrame(const ReportDocument& document, const PdfOptions& options, const PageStyle& style)
        : document_(document), options_(options), style_(style) {}

    void paint(QPainter& painter, int page, int pages) const {
        const QRectF area = style_.text_area();
        const double top = style_.mm(13.0);
        const QString number = QString("Page %1 of %2").arg(page + 1).arg(pages);
        put(painter, number, QRectF(area.left(), top, area.width(), 0.0), Qt::AlignRight);
        if (page > 0) {
            const auto head = QString::fromStdString(escape_html(document_.running_head));
            put(painter, head, QRectF(area.left(), top, area.width() - style_.mm(30.0), 0.0), Qt::AlignLeft);
            painter.fillRect(QRectF(area.left(), top + style_.mm(5.0), area.width(), style_.points(0.4)),
                             PageStyle::rule());
        }
        const auto foot = QString::fromStdString(escape_html(options_.foot));
        put(painter, foot, QRectF(area.left(), area.bottom() + style_.mm(6.0), area.width(), 0.0),
            Qt::AlignLeft);
    }

private:
    void put(QPainter& painter, const QString& html, const QRectF& where, Qt::Alignment align) const {
        if (html.isEmpty()) return;
        RichText text(style_, TextRole::running, html, align);
        text.set_width(where.width());
        text.paint(painter, where.topLeft(), PageStyle::quiet());
    }

    const ReportDocument& document_;
    const PdfOptions& options_;
    const PageStyle& style_;
};

}  // namespace

Result<std::string> pdf_bytes(const ReportDocument& document, const PdfOptions& options) {
    if (auto checked = check_painters(document, options); !checked) return fail(checked.error());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    set_up(writer, document, options.paper);
    const PageStyle style(&writer, options.paper);
    const FigurePainters figures{options.paint_plot, options.render_scene};
    const FlowedPages pages = flow(lay_out(document, style, figures), style.text_area().height());
    const PageFrame frame(document, options, style);
    QPainter painter;
    if (!painter.begin(&writer)) return fail(ErrorCode::io, "the PDF of the report could not be begun");
    int page = -1;
    for (const PlacedItem& item : pages.items) {
        for (; page < item.page; ++page) {
            if (page >= 0) writer.newPage();
            frame.paint(painter, page + 1, pages.pages);
        }
        item.paint(painter, style.text_area().topLeft() + QPointF(0.0, item.y));
    }
    if (!painter.end()) return fail(ErrorCode::io, "the PDF of the report could not be finished");
    return buffer.data().toStdString();
}

Result<void> write_pdf(const ReportDocument& document, const PdfOptions& options,
                       const std::filesystem::path& file) {
    const auto bytes = pdf_bytes(document, options);
    if (!bytes) return fail(bytes.error());
    return write_file_atomically(file, *bytes);
}

}  // namespace covaria::ui
