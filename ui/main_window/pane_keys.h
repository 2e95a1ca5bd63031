// F6 and Shift+F6: from one pane of the window to the next, with the keyboard alone.
#pragma once

#include <QMap>
#include <QObject>
#include <QPointer>
#include <functional>

class QMainWindow;
class QMenu;
class QWidget;

namespace covaria::ui {

/// Widget of a pane that the keyboard goes to: its focus proxy, itself, else the first that Tab would reach;
/// null where there is none.
QWidget* place_for_keys(QWidget& pane);

class PaneKeys : public QObject {
    Q_OBJECT
public:
    /// `panes`: in their order, those that are hidden among them.
    PaneKeys(QMainWindow& window, std::function<QList<QWidget*>()> panes);
    void add_to(QMenu& menu);

private:
    void go(int direction);
    void remember(QWidget* focused);
    QWidget* place_in(QWidget& pane) const;

    std::function<QList<QWidget*>()> panes_;
    QMap<QWidget*, QPointer<QWidget>> last_;  ///< the widget that last had the focus in a pane
};

}  // namespace covaria::ui
