// The title bar of a dock: its title, or controls of what it holds, then float and close.
#pragma once

#include <QWidget>

class QDockWidget;

namespace covaria::ui {

/// Without `controls` the dock's title is shown and follows it.
class DockTitle : public QWidget {
    Q_OBJECT
public:
    explicit DockTitle(QDockWidget& dock, QWidget* controls = nullptr);
};

}  // namespace covaria::ui
