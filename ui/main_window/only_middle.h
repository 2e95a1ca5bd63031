// F11: the stage alone, and back to the panes as they stood.
#pragma once

#include <QAction>
#include <QByteArray>
#include <QDockWidget>

class QMainWindow;

namespace covaria::ui {

/// Checked while it has put the docks away. A dock that somebody else shows ends it.
class OnlyMiddle : public QAction {
    Q_OBJECT
public:
    OnlyMiddle(QMainWindow& window, QList<QDockWidget*> docks);

private:
    void put_away();
    void bring_back();

    QMainWindow& window_;
    QList<QDockWidget*> docks_;
    QByteArray before_;
    bool moving_ = false;
};

}  // namespace covaria::ui
