#include "ui/pages/sortable_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>

#include "core/project/project_file.h"
#include "ui/document/strings.h"
#include "ui/models/roles.h"
#include "ui/models/table_text.h"

namespace covaria::ui {
namespace {

QString quoted(QString cell) {
    if (!cell.contains(QLatin1Char(',')) && !cell.contains(QLatin1Char('"')) &&
        !cell.contains(QLatin1Char('\n')))
        return cell;
    return QLatin1Char('"') + cell.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

}  // namespace

SortableTable::SortableTable(QAbstractItemModel& model, const QString& name, QWidget* parent)
    : QTableView(parent), name_(name) {
    proxy_.setSourceModel(&model);
    proxy_.setSortRole(sort_role);
    setModel(&proxy_);
    setAccessibleName(name);
    setSortingEnabled(true);
    sortByColumn(-1, Qt::AscendingOrder);
    setAlternatingRowColors(true);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(horizontalHeader(), &QWidget::customContextMenuRequested, this, &SortableTable::show_header_menu);
    connect(this, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit row_activated(proxy_.mapToSource(index).row()); });
}

void SortableTable::copy_selection() {
    QGuiApplication::clipboard()->setText(block_text(selectionModel()->selectedIndexes(), true));
}

QString SortableTable::csv() const {
    QStringList lines;
    for (int row = -1; row < proxy_.rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < proxy_.columnCount(); ++column)
            if (!isColumnHidden(column))
                cells << quoted(row < 0 ? proxy_.headerData(column, Qt::Horizontal).toString()
                                        : proxy_.index(row, column).data().toString());
        lines << cells.join(QLatin1Char(','));
    }
    return lines.join(QStringLiteral("\r\n")) + QStringLiteral("\r\n");
}

void SortableTable::save_csv(const QString& file) {
    if (const auto written = write_file_atomically(to_path(file), csv().toStdString()); !written)
        emit failed(to_qt(written.error().message));
}

void SortableTable::ask_and_save() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save Table"), name_ + QStringLiteral(".csv"),
                                                      tr("CSV table (*.csv)"));
    if (!file.isEmpty()) save_csv(file);
}

int SortableTable::current_row() const {
    return proxy_.mapToSource(currentIndex()).row();
}

void SortableTable::select_row(int row) {
    const QModelIndex index = proxy_.mapFromSource(proxy_.sourceModel()->index(row, 0));
    if (!index.isValid() || index.row() == currentIndex().row()) return;
    selecting_ = true;
    setCurrentIndex(index);
    scrollTo(index);
    selecting_ = false;
}

void SortableTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (!selecting_ && current.isValid()) emit row_selected(proxy_.mapToSource(current).row());
}

void SortableTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy_selection();
    else
        QTableView::keyPressEvent(event);
}

void SortableTable::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Copy"), QKeySequence::Copy, this, &SortableTable::copy_selection);
    menu.addAction(tr("Select All"), QKeySequence::SelectAll, this, &QTableView::selectAll);
    menu.addSeparator();
    menu.addAction(tr("Original Order"), this, [this] { sortByColumn(-1, Qt::AscendingOrder); });
    menu.addAction(tr("Save as CSV …"), this, &SortableTable::ask_and_save);
    menu.exec(event->globalPos());
}

void SortableTable::show_header_menu(QPoint at) {
    QMenu menu(this);
    for (int column = 0; column < proxy_.columnCount(); ++column) {
        QAction* action = menu.addAction(proxy_.headerData(column, Qt::Horizontal).toString());
        action->setCheckable(true);
        action->setChecked(!isColumnHidden(column));
        connect(action, &QAction::toggled, this,
                [this, column](bool shown) { setColumnHidden(column, !shown); });
    }
    menu.exec(horizontalHeader()->mapToGlobal(at));
}

}  // namespace covaria::ui
