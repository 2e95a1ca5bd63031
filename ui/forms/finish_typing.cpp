#include "ui/forms/finish_typing.h"

#include <QApplication>
#include <QPointer>
#include <QWidget>

namespace covaria::ui {

void finish_typing() {
    const QPointer<QWidget> typing = QApplication::focusWidget();
    if (!typing) return;
    typing->clearFocus();
    if (typing) typing->setFocus();
}

}  // namespace covaria::ui
