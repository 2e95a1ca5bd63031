// Texts that a user cannot read whole: they are wider or higher than their place.
#pragma once

#include <QStringList>

class QWidget;

namespace covaria::ui {

/// Cut texts of all visible widgets in `window`: labels, buttons, lists, lines, heads, cells and tabs, areas
/// that scroll sideways, and bars that hide tools; one line each, "kind name: text (px
/// short)".
QStringList cut_texts(const QWidget& window);

}  // namespace covaria::ui
