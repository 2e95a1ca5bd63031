// The result in a line of its own below the rows of a budget, in the columns of its sheet.
#pragma once

#include <QTableView>

class QAbstractItemModel;

namespace covaria::ui {

/// Follows the widths, hidden columns and scrolling of the sheet; hidden without a result.
class BudgetFoot : public QTableView {
    Q_OBJECT
public:
    BudgetFoot(QAbstractItemModel& result, const QTableView& sheet, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void align();

    const QTableView& sheet_;
};

}  // namespace covaria::ui
