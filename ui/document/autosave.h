// Keeps a recovery file of the unsaved project up to date, without ever holding up the window.
#pragma once

#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/recovery_store.h"

namespace covaria::ui {

/// The recovery file lives while there are unsaved changes and this object exists; a crash leaves it behind.
class Autosave : public QObject {
    Q_OBJECT
public:
    explicit Autosave(Document& document, RecoveryStore store = RecoveryStore(), QObject* parent = nullptr);
    ~Autosave() override;

    /// Longest time an edit stays unwritten, in milliseconds.
    void set_delay(int milliseconds) { timer_.setInterval(milliseconds); }
    /// Writes at once and waits for it.
    void flush();
    const QString& recovery_file() const { return recovery_file_; }

signals:
    /// Writing failed (full disk, permissions); said once until it works again.
    void failed(const QString& message);

private:
    void write();
    void discard();
    void report(const Result<void>& written);

    Document& document_;
    RecoveryStore store_;
    QString recovery_file_;
    std::unique_ptr<QLockFile> lock_;
    QTimer timer_;
    QThreadPool pool_;  ///< one thread: writes happen in order
    bool failing_ = false;
};

}  // namespace covaria::ui
