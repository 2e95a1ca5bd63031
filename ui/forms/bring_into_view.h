// Scrolls the pages around a field to it: Qt scrolls to what Tab reaches only.
#pragma once

#include <QScrollArea>

namespace covaria::ui {

inline void bring_into_view(QWidget& field) {
    for (QWidget* around = field.parentWidget(); around; around = around->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(around)) area->ensureWidgetVisible(&field);
}

}  // namespace covaria::ui
