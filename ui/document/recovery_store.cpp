// A recovery file is the project's text with the name of the file it belongs to.
#include "ui/document/recovery_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr const char* ending = ".recovery";

QJsonObject read_entry(const QString& recovery_file) {
    QFile file(recovery_file);
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

bool owner_is_alive(const QString& recovery_file) {
    QLockFile lock(RecoveryStore::lock_of(recovery_file));
    lock.setStaleLockTime(0);  // only the death of its process makes a lock stale
    if (!lock.tryLock(0)) return true;
    lock.unlock();
    return false;
}

}  // namespace

RecoveryStore::RecoveryStore()
    : folder_(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery") {}

QString RecoveryStore::new_name() const {
    return folder_ + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + ending;
}

Result<void> RecoveryStore::write(const QString& recovery_file, const Project& project,
                                  const QString& original_file) {
    QDir().mkpath(QFileInfo(recovery_file).absolutePath());
    const QJsonObject entry{{"file", original_file},
                            {"folder", from_path(project.directory)},
                            {"title", to_qt(project.title)},
                            {"project", to_qt(project_text(project))}};
    const QByteArray bytes = QJsonDocument(entry).toJson();
    return write_file_atomically(to_path(recovery_file), bytes.toStdString());
}

void RecoveryStore::remove_leftovers() const {
    const QString lock_ending = lock_of(QString::fromLatin1(ending));
    const QDir folder(folder_);
    for (const QFileInfo& info : folder.entryInfoList(QDir::Files | QDir::Hidden)) {
        const QString name = info.fileName();
        // ".NAME.recovery.PID-NUMBER.tmp" of an atomic write, "NAME.recovery.lock", "NAME.recovery"
        const qsizetype end = name.indexOf(QLatin1String(ending)) + qsizetype(qstrlen(ending));
        const bool temporary = name.startsWith(QLatin1Char('.')) && name.endsWith(QStringLiteral(".tmp"));
        const bool lock = name.endsWith(lock_ending), entry = name.endsWith(QLatin1String(ending));
        if (!name.contains(QLatin1String(ending)) || !(temporary || lock || entry)) continue;
        const QString of = folder.filePath(name.left(end).mid(temporary ? 1 : 0));
        if (owner_is_alive(of)) continue;
        const bool keeps = QFileInfo::exists(of) && read_entry(of).contains("project");
        if (temporary)
            QFile::remove(info.filePath());
        else if (!keeps)
            remove(of);
    }
}

std::vector<RecoveryEntry> RecoveryStore::abandoned() const {
    std::vector<RecoveryEntry> entries;
    remove_leftovers(to_path(folder_));
    const QDir folder(folder_);
    for (const QFileInfo& info : folder.entryInfoList({QString("*") + ending}, QDir::Files, QDir::Time)) {
        const QJsonObject entry = read_entry(info.filePath());
        if (!entry.contains("project") || owner_is_alive(info.filePath())) continue;
        entries.push_back(
            {info.filePath(), entry["file"].toString(), entry["title"].toString(), info.lastModified()});
    }
    return entries;
}

LoadedProject RecoveryStore::load(const RecoveryEntry& entry) {
    const QJsonObject object = read_entry(entry.recovery_file);
    const QString name = entry.original_file.isEmpty() ? entry.recovery_file : entry.original_file;
    return parse_project(to_std(object["project"].toString()), to_path(object["folder"].toString()),
                         to_std(name));
}

void RecoveryStore::remove(const QString& recovery_file) {
    QFile::remove(recovery_file);
    QFile::remove(lock_of(recovery_file));
}

}  // namespace covaria::ui
