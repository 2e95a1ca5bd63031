// Undo, as QUndoStack makes it, and for texts that cannot be read; redo.
#pragma once

#include <QString>
#include <functional>

#include "ui/document/document.h"

class QAction;

namespace covaria::ui {

/// `parent` owns them. Icon and shortcut are the caller's. `say` is told which step was undone or done again.
QAction* make_undo_action(Document& document, QObject* parent, std::function<void(const QString&)> say);

QAction* make_redo_action(Document& document, QObject* parent, std::function<void(const QString&)> say);

}  // namespace covaria::ui
