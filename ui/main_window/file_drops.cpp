#include "ui/main_window/file_drops.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <algorithm>

#include "ui/main_window/file_actions.h"
#include "ui/main_window/import_actions.h"

namespace covaria::ui {

namespace {

bool is_project(const QUrl& url) {
    return url.isLocalFile() && (url.fileName().endsWith(QStringLiteral(".covaria")) ||
                                 url.fileName().endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive));
}

}  // namespace

FileDrops::FileDrops(QWidget& window, FileActions& files, ImportActions& imports)
    : QObject(&window), files_(files), imports_(imports) {
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool FileDrops::eventFilter(QObject* watched, QEvent* event) {
    const bool enters = event->type() == QEvent::DragEnter;
    if (!enters && event->type() != QEvent::Drop) return QObject::eventFilter(watched, event);
    auto* drop = static_cast<QDropEvent*>(event);  // also what enters is one
    const QList<QUrl> urls = drop->mimeData()->urls();
    if (std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); }))
        drop->acceptProposedAction();
    if (!enters) take(urls);
    return true;
}

void FileDrops::take(const QList<QUrl>& dropped) {
    for (const QUrl& url : dropped)
        if (is_project(url)) {
            files_.open_file(url.toLocalFile());
            return;
        }
    for (const QUrl& url : dropped)
        if (url.isLocalFile()) return imports_.import_file(url.toLocalFile());
}

}  // namespace covaria::ui
