// The title bar of a dock: its title with float and close, or what its content gives for a title.
#pragma once

#include <QWidget>

class QDockWidget;

namespace covaria::ui {

/// Head of a dock: `controls`, else the dock's present title. Underlined while the keyboard is in the dock.
class DockTitle : public QWidget {
    Q_OBJECT
public:
    explicit DockTitle(QDockWidget& dock, QWidget* controls = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow(const QWidget* focused);

    QDockWidget& dock_;
    bool has_keyboard_ = false;
};

}  // namespace covaria::ui
