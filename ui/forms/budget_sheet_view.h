// The spreadsheet of a budget: its symbols stay in view, Tab goes over what can be typed.
#pragma once

#include "ui/forms/spreadsheet_view.h"

namespace covaria::ui {

class BudgetSheetView : public SpreadsheetView {
    Q_OBJECT
public:
    explicit BudgetSheetView(SpreadsheetModel& model, QWidget* parent = nullptr);
    /// As high as its rows: the result stands right below them.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {160, 120}; }
    QAction* quantity_action() const { return quantity_; }

signals:
    /// The page of a quantity is wanted: by the menu, the key, or a double click on a computed cell.
    void quantity_asked(int row);

protected:
    using SpreadsheetView::edit;
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    void focusInEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;

private:
    void place_frozen();
    void give_way_in_turn();

    const SpreadsheetModel& sheet_;
    QTableView* frozen_;  ///< the first column over the others
    QAction* quantity_;
    int rows_before_ = 0;  ///< number of rows when the present edit began
};

}  // namespace covaria::ui
