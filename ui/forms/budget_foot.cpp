#include "ui/forms/budget_foot.h"

#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>

#include "ui/theme/quiet_table.h"
#include "ui/theme/theme.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

BudgetFoot::BudgetFoot(QAbstractItemModel& result, SpreadsheetView& sheet, QWidget* parent)
    : QTableView(parent), sheet_(sheet) {
    setModel(&result);
    setItemDelegate(new TypesetDelegate(this));
    setFocusPolicy(Qt::NoFocus);
    setSelectionMode(NoSelection);
    setEditTriggers(NoEditTriggers);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollMode(ScrollPerPixel);
    horizontalHeader()->hide();
    horizontalHeader()->setMinimumSectionSize(0);
    verticalHeader()->setSectionsClickable(false);
    make_quiet(*this, RowRoom::stage);
    for (const QHeaderView* header : {sheet.horizontalHeader(), sheet.verticalHeader()}) {
        connect(header, &QHeaderView::sectionResized, this, &BudgetFoot::align);
        connect(header, &QHeaderView::geometriesChanged, this, &BudgetFoot::align);
    }
    connect(sheet.horizontalScrollBar(), &QScrollBar::valueChanged, horizontalScrollBar(),
            &QScrollBar::setValue);
    connect(sheet.horizontalScrollBar(), &QScrollBar::rangeChanged, this, &BudgetFoot::align);
    connect(&result, &QAbstractItemModel::modelReset, this, &BudgetFoot::take_result);
    take_result();
}

/// The digits that remain of a number would be another one: numbers get their room, words are cut.
void BudgetFoot::take_result() {
    for (int column = 0; column < model()->columnCount() && model()->rowCount() > 0; ++column)
        if (model()->index(0, column).data(Qt::TextAlignmentRole).toInt() & Qt::AlignRight)
            sheet_.make_room(column, sizeHintForColumn(column));
    align();
}

/// The numbers of the sheet's rows have room at its left, which the head of the result's row takes here.
void BudgetFoot::align() {
    setVisible(model()->rowCount() > 0);
    for (int column = 0; column < model()->columnCount(); ++column) {
        setColumnHidden(column, sheet_.isColumnHidden(column));
        if (!sheet_.isColumnHidden(column)) setColumnWidth(column, sheet_.columnWidth(column));
    }
    // As far as the sheet, whose scroll bar takes room, it scrolls with so much behind its last column.
    for (int column = model()->columnCount() - 1; column >= 0; --column) {
        if (isColumnHidden(column)) continue;
        const QScrollBar& bar = *sheet_.verticalScrollBar();
        setColumnWidth(column, columnWidth(column) + (bar.isVisible() ? bar.width() : 0));
        break;
    }
    verticalHeader()->setFixedWidth(sheet_.verticalHeader()->width());
    setFixedHeight(verticalHeader()->defaultSectionSize() + 2);
    horizontalScrollBar()->setValue(sheet_.horizontalScrollBar()->value());
}

void BudgetFoot::paintEvent(QPaintEvent* event) {
    QTableView::paintEvent(event);
    QPainter(viewport()).fillRect(0, 0, viewport()->width(), 1, tokens_of(palette()).ink3);
}

}  // namespace covaria::ui
