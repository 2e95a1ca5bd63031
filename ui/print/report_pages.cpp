// Pages of a report: running head, foot and flowed items on any paint device; drawings for the preview.
#include "ui/print/report_pages.h"

#include "core/text/symbol.h"
#include "ui/print/report_layout.h"
#include "ui/print/rich_text.h"

namespace covaria::ui {
namespace {

constexpr double millimetres_per_inch = 25.4;

/// Running head (project on the left, page of pages on the right) and foot of a page.
class PageFrame {
public:
    PageFrame(const ReportDocument& document, const std::string& foot, const PageStyle& style)
        : document_(document), foot_(foot), style_(style) {}

    void paint(QPainter& painter, int page, int pages) const {
        const QRectF area = style_.text_area();
        const double top = style_.mm(13.0);
        const QString number = QString::fromStdString(document_.page_words).arg(page + 1).arg(pages);
        put(painter, number, QRectF(area.left(), top, area.width(), 0.0), Qt::AlignRight);
        if (page > 0 || document_.head_on_every_page) {
            const auto head = QString::fromStdString(escape_html(document_.running_head));
            put(painter, head, QRectF(area.left(), top, area.width() - style_.mm(30.0), 0.0), Qt::AlignLeft);
            painter.fillRect(QRectF(area.left(), top + style_.mm(5.0), area.width(), style_.points(0.4)),
                             PageStyle::rule());
        }
        const auto foot = QString::fromStdString(escape_html(foot_));
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
    const std::string& foot_;
    const PageStyle& style_;
};

/// Remembers what is painted on it at the printed resolution: fonts and lengths come out as they do there.
class PrintedDrawing : public QPicture {
protected:
    int metric(PaintDeviceMetric which) const override {
        switch (which) {
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return printed_dots_per_inch;
            default:
                return QPicture::metric(which);
        }
    }
};

}  // namespace

ReportPages::ReportPages(const ReportDocument& document, const PdfOptions& options, QPaintDevice* device)
    : document_(document), options_(options), style_(device, options.paper) {
    const auto heading_pages = std::make_shared<std::vector<int>>();
    pages_ = flow(lay_out(document, style_, {options.paint_plot, options.render_scene}, heading_pages),
                  style_.text_area().height());
    for (const PlacedHeading& heading : pages_.headings) heading_pages->push_back(heading.page);
}

void ReportPages::paint(int page, QPainter& painter) const {
    PageFrame(document_, options_.foot, style_).paint(painter, page, pages_.pages);
    for (const PlacedItem& item : pages_.items)
        if (item.page == page) item.paint(painter, style_.text_area().topLeft() + QPointF(0.0, item.y));
}

double ReportPages::height_in_points(double y) const {
    return (style_.sheet().height() - style_.text_area().top() - y) / style_.points(1.0);
}

PdfPlace ReportPages::place_of(const PlacedHeading& heading) const {
    return {heading.page, height_in_points(heading.y) + 4.0};
}

std::vector<PdfBookmark> ReportPages::bookmarks() const {
    std::vector<PdfBookmark> bookmarks;
    for (const PlacedHeading& heading : pages_.headings)
        if (heading.level <= 2) bookmarks.push_back({heading.text, heading.level, place_of(heading)});
    return bookmarks;
}

std::vector<PdfLink> ReportPages::links() const {
    std::vector<PdfLink> links;
    const double left = style_.text_area().left() / style_.points(1.0),
                 right = style_.text_area().right() / style_.points(1.0);
    for (const PlacedLink& link : pages_.links)
        links.push_back({link.page, left, height_in_points(link.y + link.height), right,
                         height_in_points(link.y), place_of(pages_.headings.at(link.heading))});
    return links;
}

std::vector<PrintedPage> printed_pages(const ReportDocument& document, const PdfOptions& options) {
    PrintedDrawing measure;
    const ReportPages pages(document, options, &measure);
    const QSizeF inches = PageStyle(&measure, options.paper).sheet().size() / printed_dots_per_inch;
    std::vector<PrintedPage> printed;
    for (int page = 0; page < pages.count(); ++page) {
        PrintedDrawing drawing;
        QPainter painter(&drawing);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                               QPainter::SmoothPixmapTransform);
        pages.paint(page, painter);
        painter.end();
        printed.push_back({inches, static_cast<const QPicture&>(drawing)});
    }
    for (const PdfBookmark& bookmark : pages.bookmarks())
        printed[std::size_t(bookmark.to.page)].headings.push_back(bookmark.title);
    return printed;
}

QImage page_image(const PrintedPage& page, double dots_per_inch) {
    QImage image((page.inches * dots_per_inch).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    const double scale = dots_per_inch / printed_dots_per_inch;
    QPainter painter(&image);
    painter.scale(scale, scale);
    painter.drawPicture(QPointF(), page.drawing);
    return image;
}

}  // namespace covaria::ui
