#include "ui/pages/example_card.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr QSize picture_size(300, 188);
constexpr int padding = 12;
constexpr int summary_lines = 3;

QFont title_font(const QFont& font) {
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    return bold;
}

/// Nested ellipses on axes: what Covaria computes, of no example in particular.
void paint_placeholder(QPainter& painter, const QRectF& area, const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
    painter.fillRect(area, mix(ground, text, 0.03));
    const QPointF centre = area.center();
    painter.setPen(QPen(mix(ground, text, 0.30), 1.2));
    painter.drawLine(centre - QPointF(0.30 * area.width(), 0.0), centre + QPointF(0.30 * area.width(), 0.0));
    painter.drawLine(centre - QPointF(0.0, 0.36 * area.height()),
                     centre + QPointF(0.0, 0.36 * area.height()));
    painter.save();
    painter.translate(centre);
    painter.rotate(-28.0);
    const QColor accent = palette.color(QPalette::Highlight);
    painter.setPen(QPen(mix(ground, accent, 0.7), 1.4));
    for (const double part : {0.26, 0.16, 0.07}) {
        painter.setBrush(mix(ground, accent, 0.32 - part));
        painter.drawEllipse(QPointF(), part * area.width(), 0.75 * part * area.height());
    }
    painter.restore();
}

}  // namespace

ExampleCard::ExampleCard(const QString& title, const QString& summary, const QString& picture,
                         QWidget* parent)
    : QAbstractButton(parent), summary_(summary), picture_(picture) {
    setText(title);
    setToolTip(title + QStringLiteral("\n\n") + summary);
    setAccessibleName(title);
    setAccessibleDescription(summary);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize ExampleCard::sizeHint() const {
    const int words =
        QFontMetrics(title_font(font())).lineSpacing() * 2 + fontMetrics().lineSpacing() * summary_lines;
    return {picture_size.width() + 2, picture_size.height() + words + 2 * padding};
}

void ExampleCard::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void ExampleCard::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

void ExampleCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QColor ground = palette().color(QPalette::Base), ink = palette().color(QPalette::Text);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath shape;
    shape.addRoundedRect(frame, 5.0, 5.0);
    painter.fillPath(shape, isDown() ? mix(ground, ink, 0.06) : ground);
    painter.save();
    painter.setClipPath(shape);
    const QRect top(0, 0, width(), picture_size.height());
    if (picture_.isNull()) {
        paint_placeholder(painter, top, palette());
    } else {
        const QSizeF whole = picture_.size();
        const double scale = std::max(top.width() / whole.width(), top.height() / whole.height());
        const QSizeF part(top.width() / scale, top.height() / scale);
        painter.drawPixmap(
            QRectF(top), picture_,
            QRectF(QPointF(0.5 * (whole.width() - part.width()), 0.5 * (whole.height() - part.height())),
                   part));
    }
    painter.restore();
    const bool marked = hasFocus() || underMouse();
    painter.setPen(
        QPen(marked ? palette().color(QPalette::Highlight) : mix(ground, ink, 0.2), hasFocus() ? 2.0 : 1.0));
    painter.drawPath(shape);
    paint_words(painter, rect().adjusted(padding, top.height() + padding, -padding, -padding));
}

void ExampleCard::paint_words(QPainter& painter, const QRect& area) const {
    const QFont bold = title_font(font());
    const QFontMetrics title(bold);
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(bold);
    painter.drawText(QRect(area.topLeft(), QSize(area.width(), title.lineSpacing())), Qt::AlignLeft,
                     title.elidedText(text(), Qt::ElideRight, area.width()));
    painter.setFont(font());
    painter.setPen(mix(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.72));
    QTextLayout layout(summary_, font());
    int y = area.top() + title.lineSpacing() + 4;
    layout.beginLayout();
    for (int i = 0; i < summary_lines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) break;
        line.setLineWidth(area.width());
        const bool last = i + 1 == summary_lines;
        const QString words =
            last ? summary_.mid(line.textStart()) : summary_.mid(line.textStart(), line.textLength());
        painter.drawText(QPoint(area.left(), y + fontMetrics().ascent()),
                         fontMetrics().elidedText(words.trimmed(), Qt::ElideRight, area.width()));
        y += fontMetrics().lineSpacing();
    }
    layout.endLayout();
}

}  // namespace covaria::ui
