// A number of a table, set to its decimal sign.
#include "ui/print/number_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include "core/text/numbers.h"

namespace covaria::ui {

NumberText::NumberText(const PageStyle& style, const QString& text, const NumberLocale& locale)
    : text_(text), font_(style.figures_font()) {
    const QFontMetricsF metrics(font_, style.device());
    before_ = metrics.horizontalAdvance(text.left(decimal_sign_of(text, locale)));
    after_ = metrics.horizontalAdvance(text) - before_;
}

void NumberText::paint(QPainter& painter, QPointF point) const {
    painter.setFont(font_);
    painter.setPen(PageStyle::ink());
    painter.drawText(QPointF(point.x() - before_, point.y()), text_);
}

qsizetype decimal_sign_of(const QString& number, const NumberLocale& locale) {
    const QString group = QString::fromStdString(locale.group);
    const qsizetype sign = number.indexOf(QString::fromStdString(locale.decimal));
    if (sign >= 0) return sign;
    qsizetype end = 0;  // end of the integer part
    for (qsizetype i = 0; i < number.size(); ++i) {
        if (number[i].isDigit())
            end = i + 1;
        else if (i > 0 && number.mid(i, group.size()) != group)
            break;
    }
    return end > 0 ? end : number.size();
}

}  // namespace covaria::ui
