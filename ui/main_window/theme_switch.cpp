#include "ui/main_window/theme_switch.h"

#include <QApplication>
#include <QStyle>

#include "ui/theme/theme.h"
#include "ui/theme/wheel_scrolls.h"

namespace covaria::ui {
namespace {

const QString theme_of_system = QStringLiteral("system");

}  // namespace

bool system_is_dark() {
    // The palette that the application has without ours is the desktop's.
    const QPalette ours = QApplication::palette();
    QApplication::setPalette(QPalette());
    const QPalette desktop = QApplication::palette();
    QApplication::setPalette(ours);
    return desktop.color(QPalette::Window).lightness() < desktop.color(QPalette::WindowText).lightness();
}

namespace {

bool wants_dark(const Preferences& preferences) {
    return preferences.theme == QStringLiteral("dark") ||
           (preferences.theme == theme_of_system && system_is_dark());
}

}  // namespace

ThemeSwitch::ThemeSwitch(PreferenceStore& preferences, QObject* parent)
    : QObject(parent), preferences_(preferences) {
    qApp->installEventFilter(new WheelScrolls(this));
    apply();
    connect(&preferences_, &PreferenceStore::changed, this, [this] {
        if (wants_dark(preferences_.now()) != dark_ || !(preferences_.now().font == font_)) apply();
    });
}

void ThemeSwitch::follow_system() {
    if (preferences_.now().theme == theme_of_system && system_is_dark() != dark_) apply();
}

void ThemeSwitch::choose(const QString& key) {
    Preferences wanted = preferences_.now();
    wanted.theme = key;
    preferences_.set(wanted);
}

void ThemeSwitch::apply() {
    const Preferences& wanted = preferences_.now();
    dark_ = wants_dark(wanted);
    font_ = wanted.font;
    apply_theme(*qApp, dark_ ? Theme::dark() : Theme::light(), font_);
    emit changed(dark_);
}

}  // namespace covaria::ui
