#include "ui/theme/typeset_label.h"

#include <QPainter>
#include <cmath>
#include <utility>

#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

TypesetLabel::TypesetLabel(TextSize size, QWidget* parent) : QWidget(parent), size_(size) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void TypesetLabel::show_text(const Text& text) {
    if (text == text_) return;
    text_ = text;
    setAccessibleName(to_qt(to_unicode(text)));
    setToolTip(accessibleName());
    updateGeometry();
    update();
}

void TypesetLabel::set_rank(int rank) {
    if (std::exchange(rank_, rank) == rank) return;
    updateGeometry();  // the first rank has wider letters
    update();
}

QFont TypesetLabel::letters() const {
    QFont font = sized(this->font(), size_);
    if (rank_ > 1) font.setWeight(QFont::Normal);
    return font;
}

QSize TypesetLabel::sizeHint() const {
    const QFont font = letters();
    return {int(std::ceil(text_width(text_, font))) + 1, QFontMetrics(font).height()};
}

QSize TypesetLabel::minimumSizeHint() const {
    return {0, sizeHint().height()};
}

void TypesetLabel::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens_of(palette());
    QPainter painter(this);
    painter.setPen(rank_ == 1 ? t.ink : rank_ == 2 ? t.ink2 : t.ink3);
    const QFont font = letters();
    const LabelText label(shortened(text_, font, width()), font);
    label.draw(painter, {0.0, 0.5 * (height() - label.height())});
}

}  // namespace covaria::ui
