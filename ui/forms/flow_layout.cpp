#include "ui/forms/flow_layout.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>
#include <utility>
#include <vector>

namespace covaria::ui {

FlowLayout::~FlowLayout() {
    qDeleteAll(items_);
}

QLayoutItem* FlowLayout::takeAt(int index) {
    return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

int FlowLayout::gap() const {
    if (spacing() >= 0) return spacing();
    const QWidget* widget = parentWidget();
    return widget ? widget->style()->pixelMetric(QStyle::PM_LayoutHorizontalSpacing, nullptr, widget) : 6;
}

int FlowLayout::arrange(const QRect& rect, bool move) const {
    int x = rect.left(), y = rect.top(), line = 0;
    std::vector<std::pair<QLayoutItem*, QRect>> in_line;
    const auto end_line = [&] {
        for (const auto& [item, place] : in_line)
            if (move) item->setGeometry(place.translated(0, (line - place.height()) / 2));
        in_line.clear();
    };
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;  // hidden
        const QSize size = item->sizeHint().boundedTo(QSize(std::max(0, rect.width()), QLAYOUTSIZE_MAX));
        if (x > rect.left() && x + size.width() > rect.right() + 1) {
            end_line();
            x = rect.left();
            y += line + gap();
            line = 0;
        }
        in_line.emplace_back(item, QRect(QPoint(x, y), size));
        x += size.width() + gap();
        line = std::max(line, size.height());
    }
    end_line();
    return y + line - rect.top();
}

int FlowLayout::heightForWidth(int width) const {
    return arrange(QRect(0, 0, width, 0), false);
}

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const QLayoutItem* item : items_)
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    return least;
}

/// The size of all items in one line.
QSize FlowLayout::sizeHint() const {
    QSize all;
    for (const QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;
        all.rwidth() += item->sizeHint().width() + (all.width() > 0 ? gap() : 0);
        all.setHeight(std::max(all.height(), item->sizeHint().height()));
    }
    return all;
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    arrange(rect, true);
}

}  // namespace covaria::ui
