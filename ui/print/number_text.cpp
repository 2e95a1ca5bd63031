// A number of a table, set to its decimal point.
#include "ui/print/number_text.h"

#include <QFontMetricsF>
#include <QPainter>

namespace covaria::ui {

NumberText::NumberText(const PageStyle& style, const QString& text)
    : text_(text), font_(style.figures_font()) {
    const QFontMetricsF metrics(font_, style.device());
    const qsizetype point = text.indexOf('.');
    before_ = metrics.horizontalAdvance(point < 0 ? text : text.left(point));
    after_ = metrics.horizontalAdvance(text) - before_;
}

void NumberText::paint(QPainter& painter, QPointF point) const {
    painter.setFont(font_);
    painter.setPen(PageStyle::ink());
    painter.drawText(QPointF(point.x() - before_, point.y()), text_);
}

}  // namespace covaria::ui
