// Sizes that are taken from the font, and taken again when the user chooses another.
#pragma once

#include <functional>

class QWidget;

namespace covaria::ui {

/// `size` is called now, and whenever the widget's font has changed.
void follow_font(QWidget& widget, std::function<void()> size);

}  // namespace covaria::ui
