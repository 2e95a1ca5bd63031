// Help: the menu, and the pane with the pages.
#pragma once

#include <QObject>

#include "ui/document/document.h"
#include "ui/document/selection.h"

class QDockWidget;
class QMainWindow;
class QMenu;

namespace covaria::ui {

class HelpPane;

class HelpActions : public QObject {
    Q_OBJECT
public:
    HelpActions(QMainWindow& window, Selection& selection, Document& document);

    void add_to(QMenu& menu);
    /// F1: the field, cell or entry with the focus, else the model of the selected analysis, else the keys.
    void show_help_on_focus();
    /// A page or a place on one.
    void show_place(const QString& anchor);
    /// Made when it is first asked for.
    HelpPane& pane();

private:
    void show_keys();
    void show_dock();

    QMainWindow& window_;
    Selection& selection_;
    Document& document_;
    QDockWidget* dock_ = nullptr;
    HelpPane* pane_ = nullptr;
};

/// Versions of Covaria and of what it is built on.
QString about_text();

}  // namespace covaria::ui
