// Two views beside or above each other; a table gets the room that it needs before the other gets more than
// its own.
#pragma once

#include <QAbstractScrollArea>
#include <QSplitter>

namespace covaria::ui {

/// A splitter that cannot be closed to either side, parted as said.
QSplitter* side_by_side(QWidget* left, QWidget* right, int left_part = 1, int right_part = 1);
QSplitter* one_above_other(QWidget* top, QWidget* bottom, int top_part = 1, int bottom_part = 1);

/// Widens the side of `splitter` that `view` is in (heightens it in one that parts above from below) while
/// the view would scroll and the other side keeps what it needs: a chart's width, or half of the height. It
/// never gets smaller by itself, so that the chart does not jump from one output to the next; once the user
/// has moved the handle, it stays where it was put.
void widen_to_content(QSplitter& splitter, QAbstractScrollArea& view);

}  // namespace covaria::ui
