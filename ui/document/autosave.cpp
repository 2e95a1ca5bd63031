// Writing happens in order in one worker thread from snapshots.
#include "ui/document/autosave.h"

#include <QDir>
#include <QFile>
#include <QMetaObject>

#include "ui/theme/strings.h"

namespace covaria::ui {

Autosave::Autosave(Document& document, RecoveryStore store, QObject* parent)
    : QObject(parent), document_(document), store_(std::move(store)), recovery_file_(store_.new_name()) {
    pool_.setMaxThreadCount(1);
    timer_.setSingleShot(true);
    timer_.setInterval(1000);
    connect(&timer_, &QTimer::timeout, this, &Autosave::write);
    // Further edits do not restart it: a minute of steady typing must not stay unwritten.
    const auto schedule = [this] {
        if (document_.is_modified() && !timer_.isActive()) timer_.start();
    };
    connect(&document_, &Document::project_changed, this, schedule);
    connect(&document_, &Document::modified_changed, this, [this, schedule](bool modified) {
        if (modified)
            schedule();
        else
            discard();
    });
}

Autosave::~Autosave() {
    discard();
    pool_.waitForDone();
}

void Autosave::write() {
    if (!document_.is_modified()) return;
    if (!lock_) {
        QDir().mkpath(store_.folder());
        lock_ = std::make_unique<QLockFile>(RecoveryStore::lock_of(recovery_file_));
        lock_->setStaleLockTime(0);
        lock_->tryLock(0);
    }
    pool_.start([this, snapshot = document_.snapshot(), name = recovery_file_, file = document_.file()] {
        const Result<void> written = RecoveryStore::write(name, *snapshot, file);
        QMetaObject::invokeMethod(
            this, [this, written] { report(written); }, Qt::QueuedConnection);
    });
}

void Autosave::report(const Result<void>& written) {
    const bool was_failing = failing_;
    failing_ = !written;
    if (failing_ && !was_failing) emit failed(to_qt(written.error().message));
}

void Autosave::flush() {
    timer_.stop();
    write();
    pool_.waitForDone();
}

void Autosave::discard() {
    timer_.stop();
    pool_.start([name = recovery_file_] { QFile::remove(name); });
    pool_.waitForDone();
    lock_.reset();  // removes its own file
}

}  // namespace covaria::ui
