#include "ui/theme/wheel_scrolls.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>

namespace covaria::ui {
namespace {

/// Null: the wheel changes no value of this object.
QWidget* field_with_wheel(QObject* object) {
    if (auto* list = qobject_cast<QComboBox*>(object)) return list;
    return qobject_cast<QAbstractSpinBox*>(object);
}

bool is_scrolled(const QWidget& field) {
    for (const QWidget* above = field.parentWidget(); above; above = above->parentWidget())
        if (qobject_cast<const QAbstractScrollArea*>(above)) return true;
    return false;
}

}  // namespace

bool WheelScrolls::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
    QWidget* field = field_with_wheel(watched);
    if (!field) return false;
    if (event->type() == QEvent::Polish) {
        if (field->focusPolicy() == Qt::WheelFocus) field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (!is_scrolled(*field)) return false;
    event->ignore();  // it goes on to what scrolls
    return true;
}

}  // namespace covaria::ui
