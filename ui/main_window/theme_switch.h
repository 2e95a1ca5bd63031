// Light, dark, or as the system: the menu entries and what follows from them.
#pragma once

#include <QObject>

class QActionGroup;
class QMenu;

namespace covaria::ui {

class ThemeSwitch : public QObject {
    Q_OBJECT
public:
    explicit ThemeSwitch(QObject* parent = nullptr);
    void add_to(QMenu& menu);
    bool is_dark() const { return dark_; }
    /// "system", "light" or "dark"; remembered.
    void choose(const QString& key);

    /// The desktop's colours have changed.
    void follow_system();

signals:
    void changed(bool dark);

private:
    bool dark_ = false;
};

/// Whether the desktop asks for dark windows, as far as its own palette tells.
bool system_is_dark();

}  // namespace covaria::ui
