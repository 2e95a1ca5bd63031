// Light, dark, or as the system, and the size of the font: what follows from the preferences for the whole
// application; and what the wheel does in it.
#pragma once

#include <QObject>

#include "ui/theme/preferences.h"

namespace covaria::ui {

class ThemeSwitch : public QObject {
    Q_OBJECT
public:
    explicit ThemeSwitch(PreferenceStore& preferences, QObject* parent = nullptr);
    bool is_dark() const { return dark_; }
    /// `key`: "system", "light" or "dark"; remembered.
    void choose(const QString& key);

    /// Follows the desktop's colours, which have changed.
    void follow_system();

signals:
    void changed(bool dark);

private:
    void apply();

    PreferenceStore& preferences_;
    bool dark_ = false;
    FontChoice font_;
};

/// Whether the desktop asks for dark windows, as far as its own palette tells.
bool system_is_dark();

}  // namespace covaria::ui
