// Quiet text in the middle of an empty tab: why it is empty, and the next step.
#pragma once

#include <QLabel>

namespace covaria::ui {

class EmptyNote : public QLabel {
    Q_OBJECT
public:
    explicit EmptyNote(QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void take_theme();
};

}  // namespace covaria::ui
