// All preferences in one dialog, each applied as it is chosen.
#pragma once

#include <QDialog>

#include "ui/theme/preferences.h"

class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QScrollArea;
class QSpinBox;

namespace covaria::ui {

class QuantityEdit;
class UnitChoices;

class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(PreferenceStore& preferences, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void add_results(QFormLayout& form);
    void add_new_analyses(QFormLayout& form);
    void add_window(QFormLayout& form);
    QComboBox* add_box(QFormLayout& form, const QString& title, const char* name, const QString& help);
    QSpinBox* add_number(QFormLayout& form, const QString& title, const char* name, const QString& help,
                         std::pair<int, int> range);
    /// Stores what the controls say as the preferences.
    void take();
    void show_preferences();

    void fit();

    PreferenceStore& preferences_;
    QScrollArea* area_;
    QHBoxLayout* foot_ = nullptr;  ///< the buttons
    UnitChoices* units_ = nullptr;
    QComboBox *language_ = nullptr, *digits_ = nullptr, *numbers_ = nullptr, *factor_ = nullptr,
              *theme_ = nullptr, *family_ = nullptr;
    QuantityEdit* trials_ = nullptr;
    QSpinBox *autosave_ = nullptr, *font_ = nullptr;
};

}  // namespace covaria::ui
