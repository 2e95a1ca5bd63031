// The note on the scene while something of it is hidden.
#pragma once

#include <QString>

#include "viz/scene/visibility.h"

class QPainter;
class QWidget;

namespace covaria::ui {

/// "Only P1 is shown (Shift+H: all)"; empty: nothing of `whole` is hidden.
QString visibility_words(const Scene& whole, const Visibility& visibility);
/// Paints the words beside the cube, below the title of the scene: the legend is on the left.
void paint_note(QPainter& painter, const QWidget& view, const QString& words);

}  // namespace covaria::ui
