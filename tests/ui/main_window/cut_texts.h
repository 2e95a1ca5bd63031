// What a user cannot read whole: texts that are wider or higher than their place.
#pragma once

#include <QStringList>

class QWidget;

namespace covaria::ui {

/// Of all visible widgets in `window`: labels, buttons, lists, lines, heads, cells and tabs whose text is cut
/// or shortened, what scrolls sideways, and bars that hide tools; one line each, "kind name: text (px
/// short)".
QStringList cut_texts(const QWidget& window);

}  // namespace covaria::ui
