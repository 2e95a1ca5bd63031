#include "ui/pages/side_by_side.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <algorithm>
#include <memory>

namespace covaria::ui {
namespace {

constexpr int least_chart = 320;  ///< in which marks and their labels can be read

QSplitter* parted(Qt::Orientation orientation, QWidget* first, QWidget* second, int first_part,
                  int second_part) {
    auto* splitter = new QSplitter(orientation);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(first);
    splitter->addWidget(second);
    splitter->setStretchFactor(0, first_part);
    splitter->setStretchFactor(1, second_part);
    splitter->setSizes({1000 * first_part, 1000 * second_part});
    return splitter;
}

QScrollBar& bar_along(const QAbstractScrollArea& view, Qt::Orientation along) {
    return along == Qt::Horizontal ? *view.horizontalScrollBar() : *view.verticalScrollBar();
}

/// px of the content that are out of view; the bar of a table may count its rows.
int missing_px(const QAbstractScrollArea& view, Qt::Orientation along) {
    const auto* table = qobject_cast<const QTableView*>(&view);
    if (!table || along == Qt::Horizontal) return bar_along(view, along).maximum();
    return table->verticalHeader()->length() - table->viewport()->height();
}

void widen(QSplitter& splitter, QAbstractScrollArea& view) {
    const Qt::Orientation along = splitter.orientation();
    const int missing = missing_px(view, along);
    QList<int> sizes = splitter.sizes();
    if (missing <= 0 || !view.isVisible() || sizes.size() != 2) return;
    const QWidget* second = splitter.widget(1);
    const qsizetype own = second == &view || second->isAncestorOf(&view) ? 1 : 0;
    const qsizetype other = 1 - own;
    if (sizes[other] == 0) return;
    const int all = sizes[0] + sizes[1];
    const int kept = along == Qt::Horizontal ? std::max(least_chart, all / 5) : all / 2;
    const int more = std::min(missing, sizes[other] - kept);
    if (more <= 0) return;
    sizes[own] += more;
    sizes[other] -= more;
    splitter.setSizes(sizes);
}

}  // namespace

QSplitter* side_by_side(QWidget* left, QWidget* right, int left_part, int right_part) {
    return parted(Qt::Horizontal, left, right, left_part, right_part);
}

QSplitter* one_above_other(QWidget* top, QWidget* bottom, int top_part, int bottom_part) {
    return parted(Qt::Vertical, top, bottom, top_part, bottom_part);
}

void widen_to_content(QSplitter& splitter, QAbstractScrollArea& view) {
    auto by_hand = std::make_shared<bool>(false);
    QObject::connect(&splitter, &QSplitter::splitterMoved, &view, [by_hand] { *by_hand = true; });
    // Queued: behind the layout that found the view too small.
    QObject::connect(
        &bar_along(view, splitter.orientation()), &QScrollBar::rangeChanged, &view,
        [by_hand, &splitter, &view] {
            if (!*by_hand) widen(splitter, view);
        },
        Qt::QueuedConnection);
}

}  // namespace covaria::ui
