#include "ui/main_window/window_state.h"

#include <QMainWindow>
#include <QSettings>

#include "ui/main_window/only_middle.h"

namespace covaria::ui {

namespace {
constexpr int state_version =
    4;  // counts the sets of docks and bars: an arrangement of an older set is not applied to a newer one
}

bool restore_window(QMainWindow& window) {
    const QSettings settings;
    if (!window.isMaximized())  // on a small screen: what is remembered does not fit
        window.restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    return window.restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), state_version);
}

void remember_window(QMainWindow& window) {
    if (auto* middle = window.findChild<OnlyMiddle*>()) middle->setChecked(false);
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), window.saveGeometry());
    settings.setValue(QStringLiteral("window/state"), window.saveState(state_version));
}

}  // namespace covaria::ui
