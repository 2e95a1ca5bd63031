// A paragraph of HTML set to a width: measured, then painted on a page.
#include "ui/print/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextOption>
#include <cmath>

namespace covaria::ui {

RichText::RichText(const PageStyle& style, TextRole role, const QString& html, Qt::Alignment align)
    : document_(std::make_shared<QTextDocument>()) {
    document_->documentLayout()->setPaintDevice(style.device());
    document_->setUseDesignMetrics(true);
    document_->setDefaultFont(style.font(role));
    document_->setDocumentMargin(0.0);
    QTextOption option(align);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    document_->setDefaultTextOption(option);
    document_->setHtml(html);
    document_->setTextWidth(-1.0);
}

double RichText::natural_width() const {
    const double kept = document_->textWidth();
    document_->setTextWidth(-1.0);
    const double width = std::ceil(document_->idealWidth()) + 1.0;
    document_->setTextWidth(kept);
    return width;
}

double RichText::narrowest_width() const {
    const QFontMetricsF metrics(document_->defaultFont(), document_->documentLayout()->paintDevice());
    double widest = 0.0;
    for (const QString& word : document_->toPlainText().split(' '))
        widest = std::max(widest, metrics.horizontalAdvance(word));
    return std::ceil(1.02 * widest) + 1.0;
}

void RichText::set_width(double width) {
    document_->setTextWidth(width);
}

double RichText::height() const {
    return document_->size().height();
}

double RichText::first_baseline() const {
    document_->documentLayout()->documentSize();  // lays the text out
    const QTextLayout* layout = document_->firstBlock().layout();
    return layout->lineCount() > 0 ? layout->lineAt(0).ascent() : 0.0;
}

void RichText::paint(QPainter& painter, QPointF top_left, const QColor& color) const {
    painter.save();
    painter.translate(top_left);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, color);
    document_->documentLayout()->draw(&painter, context);
    painter.restore();
}

}  // namespace covaria::ui
