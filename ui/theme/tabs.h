// Tabs that are there for some entries only.
#pragma once

#include <QTabWidget>

namespace covaria::ui {

/// The wheel and the arrow keys pass over what is disabled, not over what is hidden.
inline void show_tab(QTabWidget& tabs, QWidget* page, bool shown) {
    const int index = tabs.indexOf(page);
    tabs.setTabEnabled(index, shown);
    tabs.setTabVisible(index, shown);
}

}  // namespace covaria::ui
