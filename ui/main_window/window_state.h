// What the window remembers between sessions: size, docks, switches.
#pragma once

class QMainWindow;

namespace covaria::ui {

/// False: nothing was remembered.
bool restore_window(QMainWindow& window);
void remember_window(QMainWindow& window);

}  // namespace covaria::ui
