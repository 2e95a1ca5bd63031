#include "ui/pages/message_panes.h"

#include <QHeaderView>
#include <QPainter>
#include <QTime>

#include "ui/models/roles.h"
#include "ui/pages/entry_delegate.h"

namespace covaria::ui {

namespace {
constexpr int most_log_lines = 5000;
}

ProblemsPane::ProblemsPane(Document& document, QWidget* parent) : QTreeView(parent), model_(document) {
    setModel(&model_);
    setItemDelegate(new EntryDelegate(this));
    setAccessibleName(tr("Problems"));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setStretchLastSection(false);  // long messages scroll instead of being cut
    header()->moveSection(ProblemsModel::message_column, ProblemsModel::place_column);
    for (int i = 0; ProblemsModel::remedy_column + i < ProblemsModel::column_count;
         ++i)  // long messages end far away
        header()->moveSection(header()->visualIndex(ProblemsModel::remedy_column + i), 1 + i);
    const auto go = [this](const QModelIndex& index) {
        const QString path = index.siblingAtColumn(ProblemsModel::message_column).data(path_role).toString();
        if (model_.take_remedy(index)) return;
        emit place_wanted(path);
    };
    connect(this, &QTreeView::clicked, this, go);
    connect(this, &QTreeView::activated, this, go);
    connect(&model_, &ProblemsModel::remedy_refused, this, &ProblemsPane::refused);
    connect(&model_, &QAbstractItemModel::modelReset, this, &ProblemsPane::show_remedies);
    show_remedies();
}

void ProblemsPane::show_remedies() {
    for (int i = 0; ProblemsModel::remedy_column + i < ProblemsModel::column_count; ++i)
        setColumnHidden(ProblemsModel::remedy_column + i, i >= model_.remedies());
}

void ProblemsPane::paintEvent(QPaintEvent* event) {
    QTreeView::paintEvent(event);
    if (model_.rowCount() > 0) return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect(), Qt::AlignCenter, tr("No problems."));
}

LogPane::LogPane(QWidget* parent) : QPlainTextEdit(parent) {
    setReadOnly(true);
    setMaximumBlockCount(most_log_lines);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Log"));
}

void LogPane::write(const QString& message) {
    const QString line = QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + message;
    QMetaObject::invokeMethod(
        this, [this, line] { appendPlainText(line); }, Qt::AutoConnection);
}

void LogPane::follow(AnalysisRunner& runner) {
    connect(&runner, &AnalysisRunner::state_changed, this, [this, &runner](const QString& id) {
        const AnalysisStatus& status = runner.status(id);
        if (status.is_current()) said_.remove(id);
        if (status.state == RunState::failed && said_.value(id) != status.message)
            write(tr("%1: %2").arg(id, said_[id] = status.message));
    });
}

}  // namespace covaria::ui
