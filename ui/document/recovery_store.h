// A folder of recovery files: what running windows have not saved yet, and what a crash left behind.
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "core/made/load_project.h"

namespace covaria::ui {

struct RecoveryEntry {
    QString recovery_file;
    QString original_file;  ///< empty: the project had never been saved
    QString title;
    QDateTime saved_at;
};

class RecoveryStore {
public:
    /// The user's own folder for such data; made when first written to.
    RecoveryStore();
    explicit RecoveryStore(QString folder) : folder_(std::move(folder)) {}

    const QString& folder() const { return folder_; }
    /// Name for the recovery file of a window that starts now.
    QString new_name() const;
    /// The lock file that a living window holds: its entry is not offered to others.
    static QString lock_of(const QString& recovery_file) { return recovery_file + ".lock"; }

    /// Safe to call from a worker thread.
    static Result<void> write(const QString& recovery_file, const Project& project,
                              const QString& original_file);

    /// Removes what a kill leaves beside the entries: half-written files, locks and unreadable entries of
    /// windows that are gone.
    void remove_leftovers() const;
    /// Entries that windows which are gone left behind, newest first.
    std::vector<RecoveryEntry> abandoned() const;
    static LoadedProject load(const RecoveryEntry& entry);
    static void remove(const QString& recovery_file);

private:
    QString folder_;
};

}  // namespace covaria::ui
