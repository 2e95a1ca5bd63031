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
