#include "ui/main_window/undo_action.h"

#include <QAction>

#include "ui/theme/strings.h"

namespace covaria::ui {

QAction* make_undo_action(Document& document, QObject* parent) {
    auto* action = new QAction(parent);
    QObject::connect(action, &QAction::triggered, &document, &Document::undo);
    const auto refresh = [&document, action] {
        const QUndoStack& stack = document.undo_stack();
        action->setEnabled(document.can_undo());
        action->setText(stack.canUndo() ? tr("&Undo %1").arg(stack.undoText()) : tr("&Undo"));
    };
    QObject::connect(&document.undo_stack(), &QUndoStack::indexChanged, action, refresh);
    QObject::connect(&document.undo_stack(), &QUndoStack::undoTextChanged, action, refresh);
    QObject::connect(&document.unread(), &UnreadTexts::changed, action, refresh);
    refresh();
    return action;
}

}  // namespace covaria::ui
