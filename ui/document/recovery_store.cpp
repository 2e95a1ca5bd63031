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
#include <filesystem>

#include "core/base/file_mode.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr const char* ending = ".recovery";

QJsonObject read_entry(const QString& recovery_file) {
    QFile file(recovery_file);
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

/// Who may not read the project may not read the copy of it either; one that has no file yet is of its user.
unsigned mode_of(const QString& project_file) {
    constexpr unsigned of_the_user = 0600, all = 0777;
    std::error_code unknown;
    const auto status = std::filesystem::status(to_path(project_file), unknown);
    if (unknown || project_file.isEmpty() || !std::filesystem::exists(status)) return of_the_user;
    return (static_cast<unsigned>(status.permissions()) & all) | of_the_user;
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
    return write_file_with_mode(to_path(recovery_file), bytes.toStdString(), mode_of(original_file));
}

void RecoveryStore::remove_leftovers() const {
    covaria::remove_leftovers(to_path(folder_));  // half-written files of atomic writes
    const QString lock_ending = lock_of(QString::fromLatin1(ending));
    const QDir folder(folder_);
    for (const QFileInfo& info : folder.entryInfoList(QDir::Files | QDir::Hidden)) {
        const QString name = info.fileName();
        // "NAME.recovery.lock", "NAME.recovery"
        const bool lock = name.endsWith(lock_ending), entry = name.endsWith(QLatin1String(ending));
        if (!lock && !entry) continue;
        const qsizetype end = name.indexOf(QLatin1String(ending)) + qsizetype(qstrlen(ending));
        const QString of = folder.filePath(name.left(end));
        if (owner_is_alive(of)) continue;
        const bool keeps = QFileInfo::exists(of) && read_entry(of).contains("project");
        if (!keeps) remove(of);
    }
}

std::vector<RecoveryEntry> RecoveryStore::abandoned() const {
    std::vector<RecoveryEntry> entries;
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
