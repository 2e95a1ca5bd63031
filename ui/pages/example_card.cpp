#include "ui/pages/example_card.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr QSize picture_size(300, 188);
constexpr int padding = 12;
constexpr int title_lines = 2;
constexpr int summary_lines = 3;
constexpr int title_gap = 4;

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

/// The last of `most` lines ends in "…" where there are more words. Gives the height of the lines.
int paint_lines(QPainter& painter, const QString& words, const QFont& font, const QRect& area, int most) {
    const QFontMetrics metrics(font);
    painter.setFont(font);
    QTextLayout layout(words, font);
    int height = 0;
    layout.beginLayout();
    for (int i = 0; i < most; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) break;
        line.setLineWidth(area.width());
        const int length = i + 1 == most ? -1 : line.textLength();
        painter.drawText(
            QPoint(area.left(), area.top() + height + metrics.ascent()),
            metrics.elidedText(words.mid(line.textStart(), length).trimmed(), Qt::ElideRight, area.width()));
        height += metrics.lineSpacing();
    }
    layout.endLayout();
    return height;
}

}  // namespace

void paint_card_picture(QPainter& painter, const QRectF& area, const QPixmap& picture,
                        const QPalette& palette) {
    const QSizeF whole = picture.size(), part = area.size().scaled(whole, Qt::KeepAspectRatio);
    const QPointF corner(0.5 * (whole.width() - part.width()), 0.5 * (whole.height() - part.height()));
    painter.drawPixmap(area, picture, QRectF(corner, part));
    if (!Theme::of(palette).is_dark()) return;
    QColor veil = palette.color(QPalette::Base);
    veil.setAlphaF(0.3F);
    painter.fillRect(area, veil);
}

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
    const int words = QFontMetrics(title_font(font())).lineSpacing() * title_lines + title_gap +
                      fontMetrics().lineSpacing() * summary_lines;
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
        paint_card_picture(painter, top, picture_, palette());
    }
    painter.restore();
    const bool marked = hasFocus() || underMouse();
    painter.setPen(
        QPen(marked ? palette().color(QPalette::Highlight) : mix(ground, ink, 0.2), hasFocus() ? 2.0 : 1.0));
    painter.drawPath(shape);
    paint_words(painter, rect().adjusted(padding, top.height() + padding, -padding, -padding));
}

void ExampleCard::paint_words(QPainter& painter, const QRect& area) const {
    painter.setPen(palette().color(QPalette::Text));
    const int title = paint_lines(painter, text(), title_font(font()), area, title_lines);
    painter.setPen(mix(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.72));
    paint_lines(painter, summary_, font(), area.adjusted(0, title + title_gap, 0, 0), summary_lines);
}

}  // namespace covaria::ui
