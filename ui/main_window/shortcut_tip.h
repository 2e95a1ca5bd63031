// Tooltips of actions name their shortcut.
#pragma once

#include <QString>

class QAction;
class QKeySequence;

namespace covaria::ui {

/// "Report as PDF (Ctrl+P)", of an action's text.
QString tip_with_shortcut(QString text, const QKeySequence& keys);
/// The tooltip follows the text ("Undo Change x") and the shortcut.
void show_shortcut(QAction* action);

}  // namespace covaria::ui
