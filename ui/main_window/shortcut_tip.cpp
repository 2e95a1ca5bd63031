#include "ui/main_window/shortcut_tip.h"

#include <QAction>
#include <QKeySequence>

namespace covaria::ui {

QString tip_with_shortcut(QString text, const QKeySequence& keys) {
    text.remove(QLatin1Char('&')).remove(QStringLiteral(" …"));
    return keys.isEmpty() ? text
                          : QStringLiteral("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText));
}

void show_shortcut(QAction* action) {
    const auto update = [action] {
        action->setToolTip(tip_with_shortcut(action->text(), action->shortcut()));
    };
    QObject::connect(action, &QAction::changed, action, update);
    update();
}

}  // namespace covaria::ui
