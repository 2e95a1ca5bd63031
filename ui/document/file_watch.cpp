// Content hashes decide, because saving atomically replaces the file and touches its time in any case.
#include "ui/document/file_watch.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include "core/base/file_io.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QByteArray content_hash(const QString& name) {
    if (name.isEmpty()) return {};
    const auto content = read_file(to_path(name));
    if (!content) return {};
    return QCryptographicHash::hash(QByteArray::fromStdString(*content), QCryptographicHash::Sha1);
}

}  // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &FileWatch::look);
}

void FileWatch::watch(const QString& file) {
    if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
    if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
    file_ = file;
    seen_ = content_hash(file);
    rearm();
}

QByteArray FileWatch::content_of(const QString& file) {
    return content_hash(file);
}

void FileWatch::was_read_as(const QByteArray& content) {
    seen_ = content;
    look();
}

bool FileWatch::is_as_seen() const {
    return !QFileInfo::exists(file_) || content_hash(file_) == seen_;
}

void FileWatch::rearm() {
    // The folder is watched too: replacing the file by renaming ends the watch on the file itself.
    if (file_.isEmpty()) return;
    if (QFileInfo::exists(file_) && !watcher_.files().contains(file_)) watcher_.addPath(file_);
    const QString folder = QFileInfo(file_).absolutePath();
    if (QFileInfo::exists(folder) && !watcher_.directories().contains(folder)) watcher_.addPath(folder);
}

void FileWatch::look() {
    rearm();
    const QByteArray now = content_hash(file_);
    if (now == seen_) return;
    seen_ = now;
    emit changed();
}

}  // namespace covaria::ui
