#include "ui/theme/elided_label.h"

#include <QPainter>
#include <QStyle>
#include <QTextDocumentFragment>

namespace covaria::ui {

ElidedLabel::ElidedLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::paintEvent(QPaintEvent* event) {
    const QRect room = contentsRect().marginsRemoved({margin(), margin(), margin(), margin()});
    QFont letters = font();
    QString words = text();
    if (Qt::mightBeRichText(words)) {
        letters.setBold(words.startsWith(QLatin1String("<b>")));
        words = QTextDocumentFragment::fromHtml(words).toPlainText();
    }
    const QString shown = QFontMetrics(letters).elidedText(words, Qt::ElideRight, room.width());
    if (shown == words) return QLabel::paintEvent(event);
    QPainter painter(this);
    painter.setFont(letters);
    style()->drawItemText(&painter, room, static_cast<int>(alignment()), palette(), isEnabled(), shown,
                          foregroundRole());
}

}  // namespace covaria::ui
