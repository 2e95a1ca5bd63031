// Help: the menu, and the pane with the pages.
#pragma once

#include <QObject>
#include <QPointer>

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
    /// Answers F1 for the field, cell or entry with the focus, else the model of the analysis, else the keys.
    void show_help_on_focus();
    /// Shows a page or a place on one.
    void show_place(const QString& anchor);
    /// The pane, made when it is first asked for.
    HelpPane& pane();
    /// The pane; null while it is hidden.
    QWidget* shown_pane() const;
    void hide();

private:
    void show_keys();
    void show_dock();
    void read();

    QMainWindow& window_;
    Selection& selection_;
    Document& document_;
    QDockWidget* dock_ = nullptr;
    HelpPane* pane_ = nullptr;
    QPointer<QWidget> before_;  ///< had the keyboard before the pane
};

/// Versions of Covaria and of what it is built on.
QString about_text();

}  // namespace covaria::ui
