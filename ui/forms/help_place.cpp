#include "ui/forms/help_place.h"

#include <QAbstractItemView>
#include <QVariant>

#include "ui/models/roles.h"

namespace covaria::ui {
namespace {
constexpr const char* place_property = "help_place";
}

void set_help_place(QWidget& widget, const QString& anchor) {
    widget.setProperty(place_property, anchor);
}

QString help_place(const QWidget* focus) {
    for (const QWidget* widget = focus; widget; widget = widget->parentWidget()) {
        if (const auto* view = qobject_cast<const QAbstractItemView*>(widget))
            if (const QString cell = view->currentIndex().data(help_role).toString(); !cell.isEmpty())
                return cell;
        if (const QString own = widget->property(place_property).toString(); !own.isEmpty()) return own;
    }
    return {};
}

}  // namespace covaria::ui
