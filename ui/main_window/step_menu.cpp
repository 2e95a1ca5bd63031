#include "ui/main_window/step_menu.h"

#include <QMenu>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int most_before = 30, most_after = 10;  // steps listed around the present one

void list_steps(QMenu& menu, Document& document) {
    menu.clear();
    const QUndoStack& stack = document.undo_stack();
    const int now = stack.index();
    const int first = std::max(0, now - most_before), last = std::min(stack.count(), now + most_after);
    for (int step = last; step >= first; --step) {
        // The oldest ones are forgotten: what stood before those is not known to be what was opened.
        QString words = step > 0 ? stack.text(step - 1) : tr("Before these steps");
        QAction* action = menu.addAction(words.replace(QLatin1Char('&'), QStringLiteral("&&")), &document,
                                         [&document, step] { document.go_to_step(step); });
        action->setCheckable(true);
        action->setChecked(step == now);
    }
}

}  // namespace

QMenu* make_step_menu(Document& document, QWidget* parent) {
    auto* menu = new QMenu(tr("Undo Lis&t"), parent);
    QUndoStack& stack = document.undo_stack();
    const auto refresh = [menu, &stack] { menu->menuAction()->setEnabled(stack.count() > 0); };
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &document] { list_steps(*menu, document); });
    QObject::connect(&stack, &QUndoStack::indexChanged, menu, refresh);
    refresh();
    return menu;
}

}  // namespace covaria::ui
