#include "ui/theme/chip.h"

#include <QPainter>
#include <cmath>

#include "ui/theme/fonts.h"
#include "ui/theme/icons.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int sign_size = 12, chip_side = 10, sign_gap = 6, chip_around = 4;  // px

/// A tick or a cross of one line.
void draw_sign(QPainter& painter, QRectF box, Chip::Kind kind, const QColor& ink) {
    painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&](double x, double y) {
        return box.topLeft() + QPointF(x * box.width(), y * box.height());
    };
    if (kind == Chip::Kind::met) {
        painter.drawPolyline(QPolygonF{at(0.1, 0.55), at(0.38, 0.83), at(0.9, 0.2)});
    } else {
        painter.drawLine(at(0.18, 0.18), at(0.82, 0.82));
        painter.drawLine(at(0.82, 0.18), at(0.18, 0.82));
    }
}

}  // namespace

Chip::Chip(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide();
}

void Chip::show_words(Kind kind, const Text& words, const QString& sign, const Text& detail) {
    kind_ = kind;
    words_ = words;
    detail_ = detail;
    sign_ = sign;
    const QString whole = to_qt(to_unicode(whole_words()));
    setAccessibleName(whole);
    setToolTip(detail.empty() ? QString() : whole);
    setVisible(!words.empty());
    updateGeometry();
    update();
}

void Chip::set_brief(bool brief) {
    if (brief == brief_) return;
    brief_ = brief;
    updateGeometry();
    update();
}

Text Chip::whole_words() const {
    return detail_.empty() ? words_ : words_ + ": " + detail_;
}

Text Chip::words() const {
    return brief_ ? words_ : whole_words();
}

QFont Chip::letters() const {
    QFont font = sized(this->font(), TextSize::small);
    font.setWeight(QFont::DemiBold);
    return font;
}

QSize Chip::sizeHint() const {
    const bool has_sign = kind_ != Kind::neutral || !sign_.isEmpty();
    const int before = has_sign ? sign_size + sign_gap : 0;
    const QFont font = letters();
    return {2 * chip_side + before + int(std::ceil(text_width(words(), font))),
            QFontMetrics(font).height() + 2 * chip_around};
}

void Chip::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens_of(palette());
    const QColor ground = kind_ == Kind::met ? t.green_tint : kind_ == Kind::not_met ? t.red_tint : t.hover;
    const QColor ink = kind_ == Kind::met ? t.green : kind_ == Kind::not_met ? t.red : t.ink2;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(rect()), 0.5 * height(), 0.5 * height());
    double x = chip_side;
    const QRectF box(x, 0.5 * (height() - sign_size), sign_size, sign_size);
    if (!sign_.isEmpty())
        icon(sign_).paint(&painter, box.toRect());
    else if (kind_ != Kind::neutral)
        draw_sign(painter, box.adjusted(1, 1, -1, -1), kind_, ink);
    if (!sign_.isEmpty() || kind_ != Kind::neutral) x += sign_size + sign_gap;
    painter.setPen(ink);
    const LabelText label(words(), letters());
    label.draw(painter, {x, 0.5 * (height() - label.height())});
}

}  // namespace covaria::ui
