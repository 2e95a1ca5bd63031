#include "ui/forms/finish_typing.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QPointer>
#include <QWidget>

namespace covaria::ui {

void finish_typing() {
    const QPointer<QWidget> typing = QApplication::focusWidget();
    if (!typing) return;
    // The editor of a cell closes when it is left: the keyboard goes back to its table.
    auto* view = typing->parentWidget()
                     ? qobject_cast<QAbstractItemView*>(typing->parentWidget()->parentWidget())
                     : nullptr;
    typing->clearFocus();
    if (view)
        view->setFocus();
    else if (typing)
        typing->setFocus();
}

}  // namespace covaria::ui
