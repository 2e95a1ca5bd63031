#include "ui/theme/fold_groups.h"

#include <QHash>
#include <QPainter>
#include <QStyleOptionButton>
#include <QVBoxLayout>

#include "ui/theme/flat_parts.h"
#include "ui/theme/fonts.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int beside_page = 16, below_page = 12;       // px around a page
constexpr int around_title = 16;                       // px above and below it together: 32 at the usual size
constexpr int chevron_width = 22, around_chevron = 8;  // px

/// Groups that the user has opened or folded, by title.
QHash<QString, bool>& left_open() {
    static QHash<QString, bool> left;
    return left;
}

QFont title_font(QFont font) {
    font.setWeight(QFont::DemiBold);
    return font;
}

}  // namespace

FoldHead::FoldHead(const QString& title, QWidget* parent) : QAbstractButton(parent) {
    setText(title);
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard in the field that it is in
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void FoldHead::set_summary(const QString& words) {
    if (words == summary_) return;
    summary_ = words;
    setAccessibleDescription(words);
    update();
}

QSize FoldHead::sizeHint() const {
    const QFontMetrics metrics(title_font(font()));
    return {chevron_width + metrics.horizontalAdvance(text()) + beside_page, metrics.height() + around_title};
}

QSize FoldHead::minimumSizeHint() const {
    return {80, sizeHint().height()};
}

void FoldHead::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens_of(palette());
    QPainter painter(this);
    if (underMouse()) painter.fillRect(rect(), t.hover);
    painter.fillRect(0, 0, width(), 1, t.line);
    const QRectF chevron(around_chevron, 0.0, 12.0, height());
    if (isChecked()) {
        draw_chevron(painter, chevron, t.ink2, Qt::DownArrow);
    } else {
        painter.save();
        painter.translate(chevron.center());
        painter.rotate(layoutDirection() == Qt::RightToLeft ? 90.0 : -90.0);
        draw_chevron(painter, QRectF(-6.0, -6.0, 12.0, 12.0), t.ink2, Qt::DownArrow);
        painter.restore();
    }
    const QFont bold = title_font(font()), small = sized(font(), TextSize::small);
    const QFontMetrics titles(bold), words(small);
    const int room = width() - chevron_width - beside_page;
    const int for_title = std::min(titles.horizontalAdvance(text()) + 2, room);
    painter.setFont(bold);
    painter.setPen(t.ink);
    painter.drawText(QRect(chevron_width, 0, for_title, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     titles.elidedText(text(), Qt::ElideRight, for_title));
    if (const int left = room - for_title - around_chevron; left > 24) {
        painter.setFont(small);
        painter.setPen(t.ink3);
        painter.drawText(QRect(chevron_width + for_title + around_chevron, 0, left, height()),
                         Qt::AlignRight | Qt::AlignVCenter, words.elidedText(summary_, Qt::ElideRight, left));
    }
    if (hasFocus()) draw_box(painter, QRectF(rect()).adjusted(2, 2, -2, -2), Qt::transparent, t.blue, 2.0);
}

FoldGroups::FoldGroups(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(0);
    column_->addStretch(1);
}

int FoldGroups::add(QWidget* page, const QString& title, bool open) {
    const int group = count();
    auto* head = title.isEmpty() ? nullptr : new FoldHead(title, this);
    auto* body = new QWidget(this);
    auto* room = new QVBoxLayout(body);
    room->setContentsMargins(0, 0, 0, 0);
    room->addWidget(page);
    // Groups within a page have heads as wide as these: their page has its margins itself.
    if (page->layout() && !page->findChild<FoldGroups*>())
        page->layout()->setContentsMargins(beside_page, head ? 2 : below_page, beside_page, below_page);
    else if (!page->layout() && head)
        room->setContentsMargins(beside_page, 2, beside_page, below_page);
    for (QWidget* part : {static_cast<QWidget*>(head), body})
        if (part) column_->insertWidget(column_->count() - 1, part);
    groups_.push_back({head, body, page});
    if (!head) return group;
    head->setChecked(left_open().value(title, open));
    connect(head, &QAbstractButton::clicked, this, [title](bool now) { left_open()[title] = now; });
    connect(head, &QAbstractButton::toggled, this, [this, group](bool now) {
        follow(group);
        if (now) emit opened(group);
    });
    follow(group);
    return group;
}

void FoldGroups::follow(int group) {
    const Group& one = at(group);
    if (one.head) one.head->setVisible(one.shown);
    one.body->setVisible(one.shown && is_open(group));
}

QString FoldGroups::title(int group) const {
    return at(group).head ? at(group).head->text() : QString();
}

bool FoldGroups::is_open(int group) const {
    return !at(group).head || at(group).head->isChecked();
}

void FoldGroups::open(int group) {
    if (at(group).head) at(group).head->setChecked(true);
}

void FoldGroups::offer(int group) {
    if (left_open().value(title(group), true)) open(group);
}

void FoldGroups::set_shown(int group, bool shown) {
    groups_[static_cast<std::size_t>(group)].shown = shown;
    follow(group);
}

void FoldGroups::set_summary(int group, const QString& words) {
    if (at(group).head) at(group).head->set_summary(words);
}

void FoldGroups::reveal(const QWidget& inside) {
    for (QWidget* around = inside.parentWidget(); around; around = around->parentWidget())
        if (auto* groups = qobject_cast<FoldGroups*>(around))
            for (int group = 0; group < groups->count(); ++group)
                if (groups->page(group) == &inside || groups->page(group)->isAncestorOf(&inside))
                    groups->open(group);
}

}  // namespace covaria::ui
