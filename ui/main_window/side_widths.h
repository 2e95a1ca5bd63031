// The widths that tree and inspector begin with.
#pragma once

#include <QList>

class QWidget;

namespace covaria::ui {

/// Widths (px) of the tree and of the inspector in a window of this width and letters.
QList<int> side_widths(const QWidget& window);

}  // namespace covaria::ui
