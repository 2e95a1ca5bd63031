// The actions carry their shortcuts, so that the context menu shows them.
#include "ui/forms/spreadsheet_view.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "ui/forms/cell_delegate.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/roles.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

namespace {

/// All cells of the first rows, those of columns that have no room in the view as well.
QModelIndexList cells_of(const QAbstractItemModel& model, int rows) {
    QModelIndexList cells;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < model.columnCount(); ++column) cells << model.index(row, column);
    return cells;
}

/// Number of rows up to the last one in which anything stands.
int filled_rows(const QAbstractItemModel& model) {
    int rows = model.rowCount();
    const auto is_empty = [&model](int row) {
        for (int column = 0; column < model.columnCount(); ++column)
            if (!model.index(row, column).data().toString().isEmpty()) return false;
        return true;
    };
    while (rows > 0 && is_empty(rows - 1)) --rows;
    return rows;
}

constexpr int most_rows_measured = 200;  // limit for pasted or imported rows
constexpr int widest_column = 320;       // limit of widths that no user has set
constexpr int far_too_wide = 60;
constexpr int give_back_after = 300;  // ms without a change
}  // namespace

SpreadsheetView::SpreadsheetView(SpreadsheetModel& model, QWidget* parent, RowRoom room)
    : QTableView(parent),
      model_(model),
      copy_(add(tr("Copy"), QKeySequence::Copy, &SpreadsheetView::copy)),
      cut_(add(tr("Cut"), QKeySequence::Cut, &SpreadsheetView::cut)),
      paste_(add(tr("Paste"), QKeySequence::Paste, &SpreadsheetView::paste)),
      clear_(add(tr("Clear"), QKeySequence::Delete, &SpreadsheetView::clear)),
      fill_down_(add(tr("Fill down"), QKeySequence(Qt::CTRL | Qt::Key_D), &SpreadsheetView::fill_down)),
      insert_row_(
          add(tr("Insert row above"), QKeySequence(Qt::CTRL | Qt::Key_I), &SpreadsheetView::insert_row)),
      append_row_(add(tr("Add row at the end"), QKeySequence(Qt::CTRL | Qt::Key_Return),
                      &SpreadsheetView::append_row)),
      remove_rows_(
          add(tr("Delete rows"), QKeySequence(Qt::CTRL | Qt::Key_Minus), &SpreadsheetView::remove_rows)) {
    setHorizontalHeader(new TypesetHeader(Qt::Horizontal, this));
    setModel(&model_);
    setItemDelegate(new CellDelegate(this));
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setSelectionMode(ExtendedSelection);
    setWordWrap(false);
    setTabKeyNavigation(true);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    make_quiet(*this, room);
    resizeColumnsToContents();
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column) {
        if (!fitting_) given_widths_.insert(column);
    });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&model_, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last) {
                update_actions();
                fit_columns(first.row(), last.row());
                give_back_.start();
            });
    connect(&model_, &QAbstractItemModel::headerDataChanged, this, [this] { fit_columns(0, -1); });
    connect(&model_, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) {
                fit_columns(first, last);
                updateGeometry();
            });
    connect(&model_, &QAbstractItemModel::rowsRemoved, this, &SpreadsheetView::updateGeometry);
    connect(&model_, &QAbstractItemModel::modelReset, this, &SpreadsheetView::updateGeometry);
    give_back_.setSingleShot(true);
    give_back_.setInterval(give_back_after);
    connect(&give_back_, &QTimer::timeout, this, &SpreadsheetView::give_back);
    update_actions();
}

QAction* SpreadsheetView::add(const QString& text, const QKeySequence& key,
                              void (SpreadsheetView::*method)()) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, method);
    addAction(action);
    return action;
}

void SpreadsheetView::set_most_rows(int rows) {
    if (std::exchange(most_rows_, rows) != rows) updateGeometry();
}

int SpreadsheetView::height_with(int rows) const {
    const int shown = std::clamp(model_.rowCount(), 1, rows);
    const int height = horizontalHeader()->sizeHint().height() +
                       shown * verticalHeader()->defaultSectionSize() + 2 * frameWidth();
    const bool scrolls = horizontalHeader()->length() > viewport()->width();
    return height + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0);
}

QSize SpreadsheetView::sizeHint() const {
    return {QTableView::sizeHint().width(), height_with(most_rows_)};
}

QSize SpreadsheetView::minimumSizeHint() const {
    return {120, sizeHint().height()};
}

void SpreadsheetView::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    give_way();
    updateGeometry();
}

/// Columns grow with what comes into these rows, unless the user has given them a width.
void SpreadsheetView::fit_columns(int first, int last) {
    fitting_ = true;
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    last = std::min(last, first + most_rows_measured - 1);
    for (int column = 0; column < model_.columnCount(); ++column) {
        if (given_widths_.contains(column)) continue;
        int wanted = horizontalHeader()->sectionSizeHint(column);
        for (int row = first; row <= last; ++row)
            wanted =
                std::max(wanted, itemDelegate()->sizeHint(option, model_.index(row, column)).width() + 1);
        if (wanted > columnWidth(column)) setColumnWidth(column, std::min(wanted, widest_column));
    }
    fitting_ = false;
    give_way();
}

void SpreadsheetView::make_room(int column, int width) {
    if (given_widths_.contains(column) || width <= columnWidth(column)) return;
    fitting_ = true;
    setColumnWidth(column, std::min(width, widest_column));
    fitting_ = false;
    give_way();
}

/// Shrinks columns typed in or cleared; computed ones stay, else columns would move with every result.
void SpreadsheetView::shrink_columns(const std::set<int>& columns, int too_wide) {
    if (model_.rowCount() > most_rows_measured) return;
    fitting_ = true;
    for (const int column : columns) {
        if (column < 0 || given_widths_.contains(column)) continue;
        const int wanted = std::max(horizontalHeader()->sectionSizeHint(column), sizeHintForColumn(column));
        if (wanted + too_wide < columnWidth(column)) setColumnWidth(column, wanted);
    }
    fitting_ = false;
    give_way();
}

/// Takes back the width of a refused text that was undone; numbers of other lengths move no column.
void SpreadsheetView::give_back() {
    if (state() == EditingState) return;
    std::set<int> all;
    for (int column = 0; column < model_.columnCount(); ++column) all.insert(column);
    shrink_columns(all, far_too_wide);
}

/// Widths of a column of words that no user has resized: for whole texts, and to tell them apart.
std::optional<SpreadsheetView::Words> SpreadsheetView::words(int column) const {
    constexpr int told_apart = 110;
    const bool has_numbers =
        model_.index(0, column).data(Qt::TextAlignmentRole).toInt() & static_cast<int>(Qt::AlignRight);
    if (has_numbers || given_widths_.contains(column) || isColumnHidden(column)) return {};
    const int head = horizontalHeader()->sectionSizeHint(column);
    const int whole = std::min(std::max(sizeHintForColumn(column), head), widest_column);
    const int least = std::max(told_apart, head);
    if (whole < least) return {};
    return Words{column, whole, least};
}

/// Names, in the second column, leave room for the numbers as far as they are still told apart; other words,
/// the last first, where all columns are in view for it.
void SpreadsheetView::give_way() {
    constexpr int names = 1;
    if (model_.columnCount() <= names) return;
    std::vector<Words> giving;
    if (const auto found = words(names)) giving.push_back(*found);
    const bool has_names = !giving.empty();
    for (int column = model_.columnCount() - 1; column > names; --column)
        if (const auto found = words(column)) giving.push_back(*found);
    int missing = horizontalHeader()->length() - viewport()->width();
    int spare = 0;
    for (const Words& column : giving) {
        missing += column.whole - columnWidth(column.at);
        spare += column.whole - column.least;
    }
    fitting_ = true;
    for (std::size_t i = 0; i < giving.size(); ++i) {
        const Words& column = giving[i];
        const bool gives = missing <= spare || (has_names && i == 0);
        const int given = gives ? std::clamp(missing, 0, column.whole - column.least) : 0;
        setColumnWidth(column.at, column.whole - given);
        missing -= given;
        spare -= column.whole - column.least;
    }
    fitting_ = false;
}

void SpreadsheetView::update_actions() {
    for (QAction* action : {cut_, paste_, clear_, fill_down_, insert_row_, append_row_, remove_rows_})
        action->setEnabled(!model_.is_linked());
}

/// Tab goes from cell to cell, and on behind the last one.
bool SpreadsheetView::focusNextPrevChild(bool next) {
    const QModelIndex now = currentIndex();
    const QModelIndex then = moveCursor(next ? MoveNext : MovePrevious, Qt::NoModifier);
    const auto before = [](const QModelIndex& a, const QModelIndex& b) {
        return std::pair(a.row(), a.column()) < std::pair(b.row(), b.column());
    };
    const bool goes_on = now.isValid() && then.isValid() && (next ? before(now, then) : before(then, now));
    return goes_on ? QTableView::focusNextPrevChild(next) : QAbstractScrollArea::focusNextPrevChild(next);
}

void SpreadsheetView::keyPressEvent(QKeyEvent* event) {
    const bool tab = event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab;
    if (tab && event->modifiers().testFlag(Qt::ControlModifier)) {
        QAbstractScrollArea::focusNextPrevChild(event->key() == Qt::Key_Tab);
        return;
    }
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier) {
        selectionModel()->select(currentIndex(), QItemSelectionModel::Toggle);
        return;
    }
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!enter || event->modifiers() != Qt::NoModifier || state() == EditingState) {
        QTableView::keyPressEvent(event);
        return;
    }
    if (currentIndex().row() == model_.rowCount() - 1)
        begin_row_below();
    else
        move_down();
}

/// Selects the cell alone. setCurrentIndex would keep the selection while Ctrl is down, as in most shortcuts.
void SpreadsheetView::go_to(const QModelIndex& cell) {
    selectionModel()->setCurrentIndex(cell, QItemSelectionModel::ClearAndSelect);
    scrollTo(cell);
}

/// Goes below, to the column in which Tab began to go along the row, as in other spreadsheets.
void SpreadsheetView::move_down() {
    const QModelIndex now = currentIndex();
    const QModelIndex below = now.sibling(now.row() + 1, began_ >= 0 ? began_ : now.column());
    if (below.isValid()) go_to(below);
}

/// Appends a row and goes to it, if the current one is the last and has something in it.
void SpreadsheetView::begin_row_below() {
    const QModelIndex now = currentIndex();
    const auto is_filled = [&](int column) {
        const QModelIndex cell = now.siblingAtColumn(column);
        return cell.data(choices_role).toStringList().isEmpty() &&
               !cell.data(Qt::EditRole).toString().isEmpty();
    };
    bool any = false;
    for (int column = 0; column < model_.columnCount() && !any; ++column) any = is_filled(column);
    const bool last = now.isValid() && now.row() == model_.rowCount() - 1;
    const int column = began_ >= 0 ? began_ : now.column();
    if (last && any && append_row_->isEnabled() && model_.insertRow(model_.rowCount()))
        go_to(model_.index(model_.rowCount() - 1, column));
}

QModelIndex SpreadsheetView::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
    tabs_on_ = action == MoveNext;
    return QTableView::moveCursor(action, modifiers);
}

void SpreadsheetView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    const bool goes_along = std::exchange(tabs_on_, false) && current.row() == previous.row();
    began_ = !goes_along ? -1 : began_ >= 0 ? began_ : previous.column();
    QTableView::currentChanged(current, previous);
}

void SpreadsheetView::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    const int typed = currentIndex().column();
    QTableView::closeEditor(editor, hint);
    shrink_columns({typed});
    if (hint == QAbstractItemDelegate::SubmitModelCache) move_down();  // Enter
}

void SpreadsheetView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addActions(actions());
    menu.exec(event->globalPos());
}

/// A whole table is copied with its heads, and without the row for new ones.
void SpreadsheetView::copy() {
    QModelIndexList cells = selectedIndexes();
    const int columns = horizontalHeader()->count() - horizontalHeader()->hiddenSectionCount();
    const bool whole = cells.size() > 1 && cells.size() == qsizetype(model_.rowCount()) * columns;
    if (whole) cells = cells_of(model_, filled_rows(model_));
    QGuiApplication::clipboard()->setText(block_text(cells, whole));
}

void SpreadsheetView::cut() {
    copy();
    clear();
}

void SpreadsheetView::paste() {
    QModelIndex corner = currentIndex();
    for (const QModelIndex& cell : selectedIndexes())
        corner = model_.index(std::min(corner.row(), cell.row()), std::min(corner.column(), cell.column()));
    const QString text = QGuiApplication::clipboard()->text();
    model_.paste(corner, corner.column() > 0 ? text : without_heads(text, model_));
}

void SpreadsheetView::clear() {
    std::set<int> columns;
    for (const QModelIndex& cell : selectedIndexes()) columns.insert(cell.column());
    model_.clear(selectedIndexes());
    shrink_columns(columns);
}

void SpreadsheetView::fill_down() {
    model_.fill_down(selectedIndexes());
}

void SpreadsheetView::insert_row() {
    const int row = currentIndex().isValid() ? currentIndex().row() : 0;
    const int column = std::max(0, currentIndex().column());
    if (model_.insertRow(row)) go_to(model_.index(row, column));
}

void SpreadsheetView::append_row() {
    if (model_.insertRow(model_.rowCount())) go_to(model_.index(model_.rowCount() - 1, 0));
}

void SpreadsheetView::remove_rows() {
    std::set<int> rows;
    for (const QModelIndex& cell : selectedIndexes()) rows.insert(cell.row());
    if (rows.empty()) return;
    const QModelIndex current = currentIndex();
    model_.remove_rows_at(rows);
    go_to(model_.index(std::min(current.row(), model_.rowCount() - 1), current.column()));
}

}  // namespace covaria::ui
