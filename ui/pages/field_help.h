// What the field with the focus means: a few lines under the forms.
#pragma once

#include <QLabel>

namespace covaria::ui {

/// Shows the help (the tooltip) of whatever has the focus within `area`.
class FieldHelp : public QLabel {
    Q_OBJECT
public:
    explicit FieldHelp(QWidget& area);

private:
    void show_help_of(const QWidget* widget);

    QWidget& area_;
};

}  // namespace covaria::ui
