// New, open, recent, save, save as, recovery, changes on disk: the life of the project's file in the window.
#pragma once

#include <QAction>
#include <QObject>
#include <QStringList>

#include "ui/document/autosave.h"
#include "ui/document/document.h"
#include "ui/main_window/dialogs.h"

class QMenu;

namespace covaria::ui {

class FileActions : public QObject {
    Q_OBJECT
public:
    FileActions(Document& document, RecoveryStore store, QObject* parent = nullptr);

    /// The questions asked; tests put scripted ones in.
    Dialogs dialogs;

    QAction* new_action;
    QAction* open_action;
    QAction* save_action;
    QAction* save_as_action;
    /// Menu of new from example and recent files, filled when it opens.
    QMenu* make_recent_menu(QWidget* parent);
    QMenu* make_examples_menu(QWidget* parent);
    QStringList recent_files() const;

    void new_project();
    void open();
    void open_file(const QString& file);
    /// Opens it as a new, unsaved project: the shipped file stays as it is.
    void open_example(const QString& file);
    bool save();
    bool save_as();
    /// Offers what a crash left behind. Returns whether something was opened.
    bool offer_recovery();
    /// Longest time an edit stays without a recovery copy.
    void set_autosave(int seconds) { autosave_.set_delay(1000 * seconds); }
    /// Asks about unsaved changes; false = stay.
    bool may_leave();

signals:
    /// There is a project now, or another one.
    void project_opened();
    void recent_changed();
    void message(const QString& text);

private:
    void opened(const QString& file, const Problems& problems);
    void remember(const QString& file);
    void ask_about_disk_change();
    void tell_saved();
    QString suggested_file(const QString& ending) const;

    Document& document_;
    RecoveryStore store_;
    Autosave autosave_;
};

/// Words for the errors among problems, one a line.
QString errors_in_words(const Problems& problems);

}  // namespace covaria::ui
