// A read-only table of results: sort by a click, choose columns, copy, save as CSV.
#pragma once

#include <QSortFilterProxyModel>
#include <QTableView>
#include <functional>
#include <map>

#include "ui/models/column_table_model.h"

class QMenu;

namespace covaria::ui {

class SortableTable : public QTableView {
    Q_OBJECT
public:
    /// `name` names the saved file ("results") and the table to screen readers.
    SortableTable(ColumnTableModel& model, const QString& name, QWidget* parent = nullptr);

    /// Hides columns, by their English heads, until the user shows them. The choice and the widths the user
    /// gave are remembered under `key`.
    void set_columns(const QString& key, const QStringList& hidden);
    void set_column_shown(int column, bool shown);
    /// Adds the columns to tick, as on a right click on the head.
    void fill_column_menu(QMenu& menu);
    /// Adds further entries to the context menu of a row of the model.
    std::function<void(QMenu& menu, int row)> extend_menu;

    /// Sets a remark, which stands below the numbers wherever they are copied or saved; empty: none.
    void set_remark(const QString& remark) { remark_ = remark; }

    void copy_selection();
    /// The columns shown, in the order shown, as the text of a CSV file.
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
    void resizeEvent(QResizeEvent* event) override;

private:
    QString column_name(int column) const;
    void apply_columns();
    void fit_columns();
    /// Gives spare room to columns of long texts, which are cut only where there is none.
    void share_room();
    void remember_width(int column, int width);
    void forget_columns();
    void show_header_menu(QPoint at);
    void ask_and_save();

    QString name_, key_, remark_;
    const ColumnTableModel& model_;
    QStringList hidden_;
    QMap<QString, QVariant> widths_;   ///< set by the user
    std::map<int, int> long_columns_;  ///< columns that want more width than the limit, and how much
    QSortFilterProxyModel proxy_;
    bool selecting_ = false;
    bool fitting_ = false;
};

}  // namespace covaria::ui
