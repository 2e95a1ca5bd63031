// The result in a line of its own below the rows of a budget, in the columns of its sheet.
#pragma once

#include <QTableView>

#include "ui/forms/spreadsheet_view.h"

namespace covaria::ui {

/// Follows the widths, hidden columns and scrolling of the sheet, which makes room for its numbers; hidden
/// without a result.
class BudgetFoot : public QTableView {
    Q_OBJECT
public:
    BudgetFoot(QAbstractItemModel& result, SpreadsheetView& sheet, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void take_result();
    void align();

    SpreadsheetView& sheet_;
};

}  // namespace covaria::ui
