// Size, docks and switches of the window, remembered between sessions.
#pragma once

class QMainWindow;

namespace covaria::ui {

/// False: nothing was remembered.
bool restore_window(QMainWindow& window);
void remember_window(QMainWindow& window);

}  // namespace covaria::ui
