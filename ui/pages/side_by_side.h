// Two views beside each other; a table gets the room that it needs before its chart gets more than its own.
#pragma once

#include <QAbstractScrollArea>
#include <QSplitter>

namespace covaria::ui {

/// A splitter that cannot be closed to either side, parted as said.
QSplitter* side_by_side(QWidget* left, QWidget* right, int left_part = 1, int right_part = 1);

/// Widens the `view` at the left of `splitter` while it would scroll sideways and the right one keeps what
/// a chart needs. It never gets narrower by itself, so that the chart does not jump from one output to the
/// next; once the user has moved the handle, it stays where it was put.
void widen_to_content(QSplitter& splitter, QAbstractScrollArea& view);

}  // namespace covaria::ui
