// Undo, as QUndoStack makes it, and for texts that cannot be read.
#pragma once

#include "ui/document/document.h"

class QAction;

namespace covaria::ui {

/// `parent` owns it. Icon and shortcut are the caller's.
QAction* make_undo_action(Document& document, QObject* parent);

}  // namespace covaria::ui
