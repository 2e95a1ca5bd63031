#include "ui/main_window/theme_switch.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QSettings>
#include <QStyle>

#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

const QString theme_key = QStringLiteral("theme");

}  // namespace

bool system_is_dark() {
    // The palette that the application has without ours is the desktop's.
    const QPalette ours = QApplication::palette();
    QApplication::setPalette(QPalette());
    const QPalette desktop = QApplication::palette();
    QApplication::setPalette(ours);
    return desktop.color(QPalette::Window).lightness() < desktop.color(QPalette::WindowText).lightness();
}

ThemeSwitch::ThemeSwitch(QObject* parent) : QObject(parent) {
    choose(QSettings().value(theme_key, QStringLiteral("system")).toString());
}

void ThemeSwitch::follow_system() {
    const QString key = QSettings().value(theme_key).toString();
    if (key == QStringLiteral("system") && system_is_dark() != dark_) choose(key);
}

void ThemeSwitch::choose(const QString& key) {
    QSettings().setValue(theme_key, key);
    dark_ = key == QStringLiteral("dark") || (key == QStringLiteral("system") && system_is_dark());
    apply_theme(*qApp, dark_ ? Theme::dark() : Theme::light());
    emit changed(dark_);
}

void ThemeSwitch::add_to(QMenu& menu) {
    auto* group = new QActionGroup(this);
    const QString chosen = QSettings().value(theme_key).toString();
    const std::pair<QString, QString> entries[] = {{QStringLiteral("system"), tr("Colours of the System")},
                                                   {QStringLiteral("light"), tr("Light")},
                                                   {QStringLiteral("dark"), tr("Dark")}};
    for (const auto& [key, text] : entries) {
        QAction* action = group->addAction(menu.addAction(text));
        action->setCheckable(true);
        action->setChecked(key == chosen);
        connect(action, &QAction::triggered, this, [this, key = key] { choose(key); });
    }
}

}  // namespace covaria::ui
