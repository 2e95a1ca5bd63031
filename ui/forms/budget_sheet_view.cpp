#include "ui/forms/budget_sheet_view.h"

#include <QAction>
#include <QFocusEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>

#include "ui/forms/budget_cell_delegate.h"
#include "ui/forms/cell_delegate.h"
#include "ui/models/budget_sheet_model.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {
namespace {

/// Whether the cell follows from the statement: typing there means the statement, which is edited then.
bool follows_from_statement(const QModelIndex& cell) {
    using Sheet = BudgetSheetModel;
    const bool follows = cell.column() == Sheet::distribution || cell.column() == Sheet::type;
    return follows && (cell.siblingAtColumn(Sheet::stated).flags() & Qt::ItemIsEditable);
}

}  // namespace

BudgetSheetView::BudgetSheetView(SpreadsheetModel& model, QWidget* parent)
    : SpreadsheetView(model, parent, RowRoom::stage), sheet_(model), frozen_(new QTableView(this)) {
    setItemDelegate(new BudgetCellDelegate(this));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollMode(ScrollPerPixel);
    frozen_->setHorizontalHeader(new TypesetHeader(Qt::Horizontal, frozen_));
    frozen_->setModel(&model);
    frozen_->setSelectionModel(selectionModel());
    frozen_->setItemDelegate(new CellDelegate(frozen_));
    frozen_->setEditTriggers(NoEditTriggers);
    frozen_->setFocusPolicy(Qt::ClickFocus);  // Tab would lead back here; set before it has a proxy
    frozen_->setFocusProxy(this);
    frozen_->verticalHeader()->hide();
    make_quiet(*frozen_);
    frozen_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    frozen_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    frozen_->setVerticalScrollMode(ScrollPerPixel);
    for (int column = 1; column < model.columnCount(); ++column) frozen_->setColumnHidden(column, true);
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, &BudgetSheetView::place_frozen);
    connect(&model, &QAbstractItemModel::dataChanged, this, &BudgetSheetView::give_way_in_turn);
    for (const auto rows : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(&model, rows, this, &BudgetSheetView::updateGeometry);
    connect(&model, &QAbstractItemModel::modelReset, this, &BudgetSheetView::updateGeometry);
    connect(verticalHeader(), &QHeaderView::geometriesChanged, this, &BudgetSheetView::place_frozen);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, frozen_->verticalScrollBar(),
            &QScrollBar::setValue);
    connect(frozen_->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(),
            &QScrollBar::setValue);
    connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, &BudgetSheetView::place_frozen);
    connect(frozen_, &QTableView::doubleClicked, this, [this](const QModelIndex& cell) {
        setFocus();
        horizontalScrollBar()->setValue(0);
        edit(cell);
    });
    quantity_ = new QAction(tr("Show Quantity"), this);
    quantity_->setToolTip(tr("Its components, observations, correlations and notes"));
    quantity_->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Return));
    quantity_->setShortcutContext(Qt::WidgetShortcut);
    addAction(quantity_);
    connect(quantity_, &QAction::triggered, this, [this] { emit quantity_asked(currentIndex().row()); });
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex& cell) {
        if (!(cell.flags() & Qt::ItemIsEditable) && !follows_from_statement(cell))
            emit quantity_asked(cell.row());
    });
    place_frozen();
}

QSize BudgetSheetView::sizeHint() const {
    return {QTableView::sizeHint().width(), height_with(model()->rowCount())};
}

/// Shows the frozen column only while the column itself is out of view: that is edited in its own place.
void BudgetSheetView::place_frozen() {
    const bool scrolled = horizontalScrollBar()->value() > 0;
    frozen_->setVisible(scrolled);
    setProperty(covered_width, scrolled ? columnWidth(0) : 0);
    horizontalHeader()->setProperty(covered_width, property(covered_width));
    frozen_->setColumnWidth(0, columnWidth(0));
    frozen_->horizontalHeader()->setFixedHeight(horizontalHeader()->height());
    frozen_->setGeometry(verticalHeader()->width() + frameWidth(), frameWidth(), columnWidth(0),
                         viewport()->height() + horizontalHeader()->height());
}

void BudgetSheetView::resizeEvent(QResizeEvent* event) {
    give_way_in_turn();
    SpreadsheetView::resizeEvent(event);
    place_frozen();
}

/// The source is the first column to go where not all have room; it stands in the inspector as well.
void BudgetSheetView::give_way_in_turn() {
    constexpr int source = BudgetSheetModel::source, name = 1, narrow_words = 110;
    int others = std::min(columnWidth(name), narrow_words);
    for (int column = 0; column < model()->columnCount(); ++column)
        if (column != name && column != source) others += columnWidth(column);
    const int wanted = std::max(std::min(sizeHintForColumn(source), narrow_words),
                                horizontalHeader()->sectionSizeHint(source));
    setColumnHidden(source, others + wanted > viewport()->width());
}

/// Keeps the cell clear of the frozen column; cells of that are in view wherever the others are scrolled to.
void BudgetSheetView::scrollTo(const QModelIndex& index, ScrollHint hint) {
    const int before = horizontalScrollBar()->value();
    SpreadsheetView::scrollTo(index, hint);
    if (index.column() == 0) {
        if (frozen_->isVisible() && state() != EditingState) horizontalScrollBar()->setValue(before);
        return;
    }
    const int hidden = columnWidth(0) - visualRect(index).left();
    if (hidden > 0) horizontalScrollBar()->setValue(horizontalScrollBar()->value() - hidden);
}

bool BudgetSheetView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    constexpr EditTriggers wanted = DoubleClicked | EditKeyPressed | AnyKeyPressed;
    if ((wanted & trigger) && follows_from_statement(index)) {
        const QModelIndex statement = index.siblingAtColumn(BudgetSheetModel::stated);
        setCurrentIndex(statement);
        return edit(statement, trigger, event);
    }
    const bool begins = SpreadsheetView::edit(index, trigger, event);
    if (begins && index.column() == 0) horizontalScrollBar()->setValue(0);  // the place of its editor
    if (begins) rows_before_ = model()->rowCount();
    return begins;
}

/// Tab goes on from the new row: the text typed into the row for new ones has become a row above it.
void BudgetSheetView::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    const QModelIndex at = currentIndex();
    const bool goes_on =
        hint == QAbstractItemDelegate::EditNextItem || hint == QAbstractItemDelegate::EditPreviousItem;
    const bool made = model()->rowCount() > rows_before_ && at.row() == model()->rowCount() - 1;
    if (!goes_on || !made) return SpreadsheetView::closeEditor(editor, hint);
    SpreadsheetView::closeEditor(editor, QAbstractItemDelegate::NoHint);
    setCurrentIndex(model()->index(at.row() - 1, at.column()));
    setCurrentIndex(
        moveCursor(hint == QAbstractItemDelegate::EditNextItem ? MoveNext : MovePrevious, Qt::NoModifier));
    SpreadsheetView::edit(currentIndex());
}

/// Tab from the equation comes to the first estimate that is missing.
void BudgetSheetView::focusInEvent(QFocusEvent* event) {
    const bool nowhere = !currentIndex().isValid() || currentIndex().row() == model()->rowCount() - 1;
    if (event->reason() == Qt::TabFocusReason && nowhere) {
        int row = 0;
        const auto estimate = [&] { return model()->index(row, BudgetSheetModel::estimate); };
        while (row + 2 < model()->rowCount() && !estimate().data(Qt::EditRole).toString().isEmpty()) ++row;
        setCurrentIndex(estimate());
    }
    SpreadsheetView::focusInEvent(event);
}

QModelIndex BudgetSheetView::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
    QModelIndex cell = SpreadsheetView::moveCursor(action, modifiers);
    if (action != MoveNext && action != MovePrevious) return cell;
    const int cells = model()->rowCount() * model()->columnCount(), columns = model()->columnCount();
    const auto passes = [&] {
        return !(cell.flags() & Qt::ItemIsEditable) || (action == MoveNext && sheet_.is_passed_over(cell));
    };
    for (int i = 0; i < cells && cell.isValid() && passes(); ++i) {
        const int next = cell.row() * columns + cell.column() + (action == MoveNext ? 1 : cells - 1);
        cell = model()->index((next % cells) / columns, next % columns);
    }
    return cell;
}

}  // namespace covaria::ui
