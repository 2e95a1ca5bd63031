// The questions the window asks, replaceable by scripted answers in tests.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace covaria::ui {

enum class SaveAnswer { save, discard, cancel };
enum class DiskAnswer { reload, keep };
/// `later`: the project is kept, and asked about at the next start.
struct RecoverAnswer {
    enum class What { recover, later, discard } what = What::later;
    int entry = 0;  ///< index of the chosen one among the entries that were offered
};

struct Dialogs {
    std::function<QString(const QString& folder)> file_to_open;
    /// Parameters: title, folder, filter; empty = cancelled.
    std::function<QString(const QString& title, const QString& folder, const QString& filter)> file_to_import;
    /// Parameters: title, suggested path, filter ("PDF document (*.pdf)"); empty = cancelled.
    std::function<QString(const QString& title, const QString& suggested, const QString& filter)>
        file_to_save;
    /// Empty = cancelled.
    std::function<QString(const QString& title)> folder_to_search;
    std::function<SaveAnswer(const QString& name)> save_changes;
    std::function<DiskAnswer(const QString& name, bool modified)> changed_on_disk;
    /// Asks what to do with which of the kept projects, each named by its title and time.
    std::function<RecoverAnswer(const QStringList& entries)> recover;
    std::function<bool(const QString& question, const QString& action)> confirm;
    std::function<QString(const QString& title, const QString& label, const QString& text)> ask_text;
    std::function<void(const QString& title, const QString& message)> show_message;
};

/// Qt's own dialogs, over `parent`.
Dialogs standard_dialogs(QWidget* parent);

/// Folder in which the user last opened, saved, imported or exported a file, also in an earlier session; at
/// first the one where documents are kept. All dialogs begin there.
QString last_folder();
void remember_folder_of(const QString& file);

}  // namespace covaria::ui
