#include "ui/pages/side_by_side.h"

#include <QScrollBar>
#include <algorithm>
#include <memory>

namespace covaria::ui {
namespace {

constexpr int least_chart = 320;  ///< in which marks and their labels can be read

void widen(QSplitter& splitter, QAbstractScrollArea& view) {
    const int missing = view.horizontalScrollBar()->maximum();
    const QList<int> sizes = splitter.sizes();
    if (missing <= 0 || !view.isVisible() || sizes.size() != 2 || sizes[1] == 0) return;
    const int kept = std::max(least_chart, (sizes[0] + sizes[1]) / 4);
    const int more = std::min(missing, sizes[1] - kept);
    if (more > 0) splitter.setSizes({sizes[0] + more, sizes[1] - more});
}

}  // namespace

QSplitter* side_by_side(QWidget* left, QWidget* right, int left_part, int right_part) {
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(left);
    splitter->addWidget(right);
    splitter->setStretchFactor(0, left_part);
    splitter->setStretchFactor(1, right_part);
    splitter->setSizes({1000 * left_part, 1000 * right_part});
    return splitter;
}

void widen_to_content(QSplitter& splitter, QAbstractScrollArea& view) {
    auto by_hand = std::make_shared<bool>(false);
    QObject::connect(&splitter, &QSplitter::splitterMoved, &view, [by_hand] { *by_hand = true; });
    // Behind the layout that found the view too narrow.
    QObject::connect(
        view.horizontalScrollBar(), &QScrollBar::rangeChanged, &view,
        [by_hand, &splitter, &view] {
            if (!*by_hand) widen(splitter, view);
        },
        Qt::QueuedConnection);
}

}  // namespace covaria::ui
