// Meaning of the field with the focus: a few lines under the forms.
#pragma once

#include <QLabel>
#include <QPointer>

namespace covaria::ui {

/// Shows the help (the tooltip) of whatever has the focus within `area`.
class FieldHelp : public QLabel {
    Q_OBJECT
public:
    explicit FieldHelp(QWidget& area);

    /// Says what to know about fields in general: no field is looked at any more.
    void start_over(bool has_numbers = true);

protected:
    /// Follows the field's tooltip, so that a complaint goes when it is solved.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void follow(QWidget* widget);
    void show_help();

    QWidget& area_;
    QPointer<QWidget> shown_;
};

}  // namespace covaria::ui
