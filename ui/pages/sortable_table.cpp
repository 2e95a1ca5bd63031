#include "ui/pages/sortable_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QResizeEvent>
#include <QSettings>
#include <algorithm>

#include "core/project/project_file.h"
#include "core/result_files/csv_text.h"
#include "core/result_files/csv_writer.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/roles.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"
#include "ui/theme/quiet_table.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {
namespace {

constexpr int widest_column = 260;  ///< limit of widths that no user has set

}  // namespace

SortableTable::SortableTable(ColumnTableModel& model, const QString& name, QWidget* parent)
    : QTableView(parent), name_(name), model_(model) {
    setHorizontalHeader(new TypesetHeader(Qt::Horizontal, this));
    setVerticalHeader(new TypesetHeader(Qt::Vertical, this));
    setItemDelegate(new TypesetDelegate(this));
    proxy_.setSourceModel(&model);
    proxy_.setSortRole(sort_role);
    setModel(&proxy_);
    setAccessibleName(name);
    setSortingEnabled(true);
    sortByColumn(-1, Qt::AscendingOrder);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setWordWrap(false);
    setTabKeyNavigation(false);
    make_quiet(*this);
    verticalHeader()->hide();
    QHeaderView* head = horizontalHeader();
    head->setContextMenuPolicy(Qt::CustomContextMenu);
    head->setToolTip(tr("Click to sort, right click to choose columns"));
    connect(head, &QWidget::customContextMenuRequested, this, &SortableTable::show_header_menu);
    connect(head, &QHeaderView::sectionResized, this,
            [this](int column, int, int width) { remember_width(column, width); });
    connect(head, &QHeaderView::sortIndicatorChanged, this, &SortableTable::fit_columns);
    connect(&proxy_, &QAbstractItemModel::modelReset, this, &SortableTable::apply_columns);
    connect(&proxy_, &QAbstractItemModel::dataChanged, this, &SortableTable::fit_columns);
    follow_font(*this, [this] { fit_columns(); });
    connect(this, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit row_activated(proxy_.mapToSource(index).row()); });
}

void SortableTable::set_columns(const QString& key, const QStringList& hidden) {
    key_ = QStringLiteral("tables/") + key;
    hidden_ = hidden;
    const QSettings settings;
    if (settings.contains(key_ + QStringLiteral("/hidden")))
        hidden_ = settings.value(key_ + QStringLiteral("/hidden")).toStringList();
    widths_ = settings.value(key_ + QStringLiteral("/widths")).toMap();
    apply_columns();
}

QString SortableTable::column_name(int column) const {
    const QString name = proxy_.headerData(column, Qt::Horizontal, id_role).toString();
    return name.isEmpty() ? proxy_.headerData(column, Qt::Horizontal).toString() : name;
}

void SortableTable::apply_columns() {
    fitting_ = true;  // columns that appear keep their former width, which is no wish of the user
    for (int column = 0; column < proxy_.columnCount(); ++column)
        setColumnHidden(column, hidden_.contains(column_name(column)));
    fit_columns();
}

void SortableTable::fit_columns() {
    fitting_ = true;
    long_columns_.clear();
    for (int column = 0; column < proxy_.columnCount(); ++column) {
        if (isColumnHidden(column)) continue;
        const QVariant given = widths_.value(column_name(column));
        const int wanted = std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
        if (!given.isValid() && wanted > widest_column) long_columns_[column] = wanted;
        setColumnWidth(column, given.isValid() ? given.toInt() : std::min(wanted, widest_column));
    }
    share_room();
    fitting_ = false;
}

void SortableTable::share_room() {
    for (const auto& [column, wanted] : long_columns_) setColumnWidth(column, widest_column);
    int spare = viewport()->width() - horizontalHeader()->length();
    for (const auto& [column, wanted] : long_columns_) {
        if (spare <= 0) return;
        const int more = std::min(spare, wanted - widest_column);
        setColumnWidth(column, widest_column + more);
        spare -= more;
    }
}

void SortableTable::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    if (long_columns_.empty() || event->oldSize().width() == event->size().width()) return;
    fitting_ = true;
    share_room();
    fitting_ = false;
}

void SortableTable::remember_width(int column, int width) {
    if (fitting_ || width == 0 || key_.isEmpty()) return;
    widths_[column_name(column)] = width;
    QSettings().setValue(key_ + QStringLiteral("/widths"), widths_);
}

void SortableTable::set_column_shown(int column, bool shown) {
    const QString name = column_name(column);
    hidden_.removeAll(name);
    if (!shown) hidden_ << name;
    if (!key_.isEmpty()) QSettings().setValue(key_ + QStringLiteral("/hidden"), hidden_);
    fitting_ = true;
    setColumnHidden(column, !shown);
    fit_columns();
}

void SortableTable::forget_columns() {
    widths_.clear();
    if (!key_.isEmpty()) QSettings().remove(key_ + QStringLiteral("/widths"));
    fit_columns();
}

void SortableTable::copy_selection() {
    QString text = block_text(selectionModel()->selectedIndexes(), true);
    if (!remark_.isEmpty()) text += remark_ + QLatin1Char('\n');
    QGuiApplication::clipboard()->setText(text);
}

QString SortableTable::csv() const {
    std::vector<int> rows, columns;
    for (int row = 0; row < proxy_.rowCount(); ++row)
        rows.push_back(proxy_.mapToSource(proxy_.index(row, 0)).row());
    for (int column = 0; column < proxy_.columnCount(); ++column)
        if (!isColumnHidden(column)) columns.push_back(column);
    const std::string text = to_csv(model_.file_table(rows, columns), model_.units());
    return to_qt(remark_.isEmpty() ? text : text + csv_text(to_std(remark_)) + "\r\n");
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
    menu.addAction(icon(QStringLiteral("copy")), tr("Copy"), QKeySequence::Copy, this,
                   &SortableTable::copy_selection);
    menu.addAction(tr("Select All"), QKeySequence::SelectAll, this, &QTableView::selectAll);
    menu.addSeparator();
    const QModelIndex cell = indexAt(event->pos());
    if (extend_menu && cell.isValid()) extend_menu(menu, proxy_.mapToSource(cell).row());
    fill_column_menu(*menu.addMenu(tr("Columns")));
    if (isSortingEnabled())
        menu.addAction(tr("Original Order"), this, [this] { sortByColumn(-1, Qt::AscendingOrder); });
    menu.addAction(icon(QStringLiteral("export")), tr("Save as CSV …"), this, &SortableTable::ask_and_save);
    menu.exec(event->globalPos());
}

void SortableTable::fill_column_menu(QMenu& menu) {
    for (int column = 0; column < proxy_.columnCount(); ++column) {
        QAction* action = menu.addAction(proxy_.headerData(column, Qt::Horizontal).toString());
        action->setCheckable(true);
        action->setChecked(!isColumnHidden(column));
        connect(action, &QAction::toggled, this,
                [this, column](bool shown) { set_column_shown(column, shown); });
    }
    menu.addSeparator();
    menu.addAction(tr("Fit Widths"), this, &SortableTable::forget_columns);
}

void SortableTable::show_header_menu(QPoint at) {
    QMenu menu(this);
    fill_column_menu(menu);
    menu.exec(horizontalHeader()->mapToGlobal(at));
}

}  // namespace covaria::ui
