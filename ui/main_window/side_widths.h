// The widths that tree and inspector begin with.
#pragma once

#include <QList>

class QWidget;

namespace covaria::ui {

/// Of the tree and of the inspector (px), in a window of that width and letters.
QList<int> side_widths(const QWidget& window);

}  // namespace covaria::ui
