// Tells when somebody else changes the file of the document.
#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

namespace covaria::ui {

class FileWatch : public QObject {
    Q_OBJECT
public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches `file` from its present content on; an empty name watches nothing.
    void watch(const QString& file);
    const QString& file() const { return file_; }
    /// Content of `file` at this moment, to be told whether it was another when it was read.
    static QByteArray content_of(const QString& file);
    /// The watched file was read when it had this content: `changed` follows if it has another one by now.
    void was_read_as(const QByteArray& content);
    /// Nobody has changed it unseen: watchers of files are told of nothing on some network drives.
    bool is_as_seen() const;

signals:
    /// The content differs from what it was at `watch`, or the file is gone. Once per new content.
    void changed();

private:
    void look();
    void rearm();

    QFileSystemWatcher watcher_;
    QString file_;
    QByteArray seen_;
};

}  // namespace covaria::ui
