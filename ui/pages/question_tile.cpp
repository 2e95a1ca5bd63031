#include "ui/pages/question_tile.h"

#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/theme/fonts.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int picture_height = 132, least_width = 150, usual_width = 216, tile_margin = 16, tile_lines = 3;
constexpr QSizeF drawing_size(210.0, 132.0);  ///< size for which the drawings are made

/// Draws with one pen and one blue.
class Drawer {
public:
    Drawer(QPainter& painter, const Tokens& tokens) : p_(painter), t_(tokens) { use_pen(); }

    void equation() {
        QPainterPath bell(QPointF(34, 92));
        for (int i = 0; i <= 60; ++i) {
            const double x = 34.0 + 142.0 * i / 60.0, z = (x - 105.0) / 25.0;
            bell.lineTo(x, 92.0 - 62.0 * std::exp(-0.5 * z * z));
        }
        bell.closeSubpath();
        p_.fillPath(bell, t_.fill);
        line({{24, 92}, {186, 92}});
        line({{66, 103}, {144, 103}});
        line({{66, 97}, {66, 109}});
        line({{144, 97}, {144, 109}});
    }
    void points() {
        p_.drawRoundedRect(QRectF(44, 34, 28, 26), 5, 5);
        for (const double foot : {39.0, 58.0, 77.0}) line({{58, 60}, {foot, 108}});
        p_.setPen(QPen(t_.line2, 3, Qt::CustomDashLine, Qt::FlatCap));
        QPen dashes = p_.pen();
        dashes.setDashPattern({2.2, 1.6});
        p_.setPen(dashes);
        for (const QPointF& to : {QPointF(132, 30), QPointF(154, 62), QPointF(128, 94)})
            p_.drawLine(QPointF(76, 47), to);
        ellipse({148, 26}, 15, 9, -15);
        ellipse({172, 60}, 17, 9, 5);
        ellipse({144, 98}, 15, 9, 20);
        use_pen();
    }
    void pose() {
        ellipse({112, 44}, 36, 24, -6);
        p_.setPen(QPen(t_.ink, 4, Qt::SolidLine, Qt::RoundCap));
        p_.drawLine(QPointF(112, 44), QPointF(112, 14));
        p_.drawLine(QPointF(112, 44), QPointF(142, 54));
        p_.drawLine(QPointF(112, 44), QPointF(86, 62));
        use_pen();
        line({{38, 104}, {84, 82}, {168, 90}, {134, 116}, {38, 104}});
    }
    void robot() {
        ellipse({146, 86}, 26, 15, 0);
        line({{44, 114}, {90, 114}});
        line({{66, 114}, {66, 100}});
        line({{68, 86}, {86, 44}});
        line({{95, 39}, {136, 52}});
        line({{144, 62}, {144, 74}});
        for (const QPointF& joint : {QPointF(66, 92), QPointF(88, 36), QPointF(144, 54)})
            p_.drawEllipse(joint, 8, 8);
    }
    void file() {
        line({{56, 16}, {122, 16}, {144, 38}, {144, 114}, {56, 114}, {56, 16}});
        line({{122, 16}, {122, 38}, {144, 38}});
        for (const double y : {60.0, 78.0, 96.0}) line({{72, y}, {y > 90 ? 104.0 : 128.0, y}});
        p_.setPen(QPen(t_.fill, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        line({{170, 54}, {170, 98}});
        line({{154, 84}, {170, 100}, {186, 84}});
        use_pen();
    }

private:
    void use_pen() {
        p_.setPen(QPen(t_.ink2, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        p_.setBrush(Qt::NoBrush);
    }
    void line(const QPolygonF& through) { p_.drawPolyline(through); }
    void ellipse(QPointF at, double a, double b, double turned) {
        p_.save();
        p_.translate(at);
        p_.rotate(turned);
        p_.setPen(Qt::NoPen);
        p_.setBrush(t_.fill);
        p_.drawEllipse(QPointF(), a, b);
        p_.restore();
    }

    QPainter& p_;
    const Tokens& t_;
};

}  // namespace

QuestionTile::QuestionTile(Drawing drawing, const QString& title, const QString& words, QMenu* menu,
                           QWidget* parent)
    : QAbstractButton(parent), drawing_(drawing), words_(words), menu_(menu) {
    menu_->setParent(this, menu_->windowFlags());
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(words);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::clicked, this,
            [this] { menu_->popup(mapToGlobal(QPoint(0, picture_height))); });
}

QFont QuestionTile::title_font() const {
    return sized(font(), TextSize::title);
}

QSize QuestionTile::sizeHint() const {
    const int words = QFontMetrics(title_font()).lineSpacing() + 4 + tile_lines * fontMetrics().lineSpacing();
    return {std::max(least_width, usual_width - 40), picture_height + words + 2 * tile_margin};
}

void QuestionTile::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens_of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool marked = hasFocus() || underMouse();
    const double width = hasFocus() ? 2.0 : 1.0, round = 6.0;
    const QRectF frame = QRectF(rect()).adjusted(0.5 * width, 0.5 * width, -0.5 * width, -0.5 * width);
    QPainterPath outline;
    outline.addRoundedRect(frame, round, round);
    painter.fillPath(outline, t.stage);
    painter.save();
    painter.setClipPath(outline);
    painter.fillRect(QRect(0, 0, this->width(), picture_height), t.panel);
    painter.fillRect(QRect(0, picture_height, this->width(), 1), t.line);
    const double scale = std::min(1.0, (this->width() - 8.0) / drawing_size.width());
    painter.translate(0.5 * (this->width() - scale * drawing_size.width()),
                      0.5 * (picture_height - scale * drawing_size.height()));
    painter.scale(scale, scale);
    Drawer drawer(painter, t);
    switch (drawing_) {
        case Drawing::equation:
            drawer.equation();
            break;
        case Drawing::points:
            drawer.points();
            break;
        case Drawing::pose:
            drawer.pose();
            break;
        case Drawing::robot:
            drawer.robot();
            break;
        case Drawing::file:
            drawer.file();
            break;
    }
    painter.restore();
    painter.setPen(QPen(marked ? t.blue : t.line2, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(outline);
    QRect area = rect().adjusted(tile_margin, picture_height + 12, -tile_margin, -8);
    painter.setPen(t.ink);
    painter.setFont(title_font());
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, area.width()));
    area.setTop(area.top() + painter.fontMetrics().lineSpacing() + 4);
    painter.setFont(font());
    painter.setPen(t.ink2);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words_);
}

/// Return as well: it is the one thing that can be done here.
void QuestionTile::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void QuestionTile::enterEvent(QEnterEvent* event) {
    QAbstractButton::enterEvent(event);
    update();
}

void QuestionTile::leaveEvent(QEvent* event) {
    QAbstractButton::leaveEvent(event);
    update();
}

}  // namespace covaria::ui
