// Undo, as QUndoStack makes it, and for texts that cannot be read; redo.
#pragma once

#include <QString>
#include <functional>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"

class QAction;

namespace covaria::ui {

/// `parent` owns them. Icon and shortcut are the caller's. `say` is told which step was undone or done again.
/// `go` is asked to lead to the entry that was changed back, where it is one.
QAction* make_undo_action(Document& document, QObject* parent, std::function<void(const QString&)> say,
                          std::function<void(const SetupAddress&)> go);

QAction* make_redo_action(Document& document, QObject* parent, std::function<void(const QString&)> say);

}  // namespace covaria::ui
