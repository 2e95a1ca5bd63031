#include "ui/main_window/undo_action.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// Whether the line edits a cell: the view closes it as well.
bool edits_cell(const QLineEdit& line) {
    const QWidget* around = line.parentWidget();
    return around && qobject_cast<QAbstractItemView*>(around->parentWidget());
}

/// Entries of `after` that are not as they were.
template <class Entry>
void take_changed(const std::vector<Entry>& before, const std::vector<Entry>& after, SetupOwner owner,
                  std::vector<SetupAddress>& changed) {
    for (const Entry& entry : after)
        if (std::ranges::find(before, entry) == before.end()) changed.push_back({owner, entry.id});
}

/// The one entry that a step changed; nullopt if it changed none or several.
std::optional<SetupAddress> changed_entry(const Project& before, const Project& after) {
    std::vector<SetupAddress> changed;
    take_changed(before.assets, after.assets, SetupOwner::asset, changed);
    take_changed(before.analyses, after.analyses, SetupOwner::analysis, changed);
    return changed.size() == 1 ? std::optional(changed.front()) : std::nullopt;
}

/// A field in which nothing was typed leaves undo to the document.
class UndoOfFields : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride ||
            !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo))
            return false;
        auto* line = qobject_cast<QLineEdit*>(watched);
        if (auto* box = qobject_cast<QAbstractSpinBox*>(watched)) line = box->findChild<QLineEdit*>();
        if (!line || line->isUndoAvailable() || edits_cell(*line)) return false;
        event->ignore();
        return true;
    }
};

}  // namespace

QAction* make_redo_action(Document& document, QObject* parent, std::function<void(const QString&)> say) {
    QUndoStack& stack = document.undo_stack();
    QAction* action = stack.createRedoAction(parent, tr("&Redo"));
    QObject::connect(action, &QAction::triggered, &document,  // behind the stack, which has done it
                     [&stack, say = std::move(say)] { say(tr("Done again: %1").arg(stack.undoText())); });
    return action;
}

QAction* make_undo_action(Document& document, QObject* parent, std::function<void(const QString&)> say,
                          std::function<void(const SetupAddress&)> go) {
    auto* action = new QAction(parent);
    QObject::connect(action, &QAction::triggered, &document,
                     [&document, say = std::move(say), go = std::move(go)] {
                         const QUndoStack& stack = document.undo_stack();
                         const int before = stack.index();
                         const QString step = stack.undoText();
                         const ProjectSnapshot project = document.snapshot();
                         document.undo();
                         if (stack.index() >= before) return;
                         say(tr("Undone: %1").arg(step));
                         if (const auto entry = changed_entry(*project, document.project())) go(*entry);
                     });
    const auto refresh = [&document, action] {
        const QUndoStack& stack = document.undo_stack();
        action->setEnabled(document.can_undo());
        action->setText(stack.canUndo() ? tr("&Undo %1").arg(stack.undoText()) : tr("&Undo"));
    };
    QObject::connect(&document.undo_stack(), &QUndoStack::indexChanged, action, refresh);
    QObject::connect(&document.undo_stack(), &QUndoStack::undoTextChanged, action, refresh);
    QObject::connect(&document.unread(), &UnreadTexts::changed, action, refresh);
    refresh();
    QCoreApplication::instance()->installEventFilter(new UndoOfFields(action));
    return action;
}

}  // namespace covaria::ui
