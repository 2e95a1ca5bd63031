// A read-only table of results: sort by a click, choose columns, copy, save as CSV.
#pragma once

#include <QSortFilterProxyModel>
#include <QTableView>

namespace covaria::ui {

class SortableTable : public QTableView {
    Q_OBJECT
public:
    /// `name` names the saved file ("results") and the table to screen readers.
    SortableTable(QAbstractItemModel& model, const QString& name, QWidget* parent = nullptr);

    void copy_selection();
    /// Everything shown, in the order shown.
    QString csv() const;
    void save_csv(const QString& file);
    /// Row of the model under the current row of the view; -1 = none.
    int current_row() const;
    void select_row(int row);

signals:
    void row_selected(int row);
    void row_activated(int row);
    void failed(const QString& message);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void show_header_menu(QPoint at);
    void ask_and_save();

    QString name_;
    QSortFilterProxyModel proxy_;
    bool selecting_ = false;
};

}  // namespace covaria::ui
