// A table that behaves like a spreadsheet: keyboard, copy and paste of blocks, fill down, rows.
#pragma once

#include <QAction>
#include <QTableView>
#include <QTimer>
#include <optional>
#include <set>

#include "ui/models/spreadsheet_model.h"
#include "ui/theme/quiet_table.h"

namespace covaria::ui {

class SpreadsheetView : public QTableView {
    Q_OBJECT
public:
    explicit SpreadsheetView(SpreadsheetModel& model, QWidget* parent = nullptr,
                             RowRoom room = RowRoom::inspector);

    QAction* copy_action() const { return copy_; }
    QAction* cut_action() const { return cut_; }
    QAction* paste_action() const { return paste_; }
    QAction* clear_action() const { return clear_; }
    QAction* fill_down_action() const { return fill_down_; }
    QAction* insert_row_action() const { return insert_row_; }
    QAction* append_row_action() const { return append_row_; }
    QAction* remove_rows_action() const { return remove_rows_; }

    static constexpr int usual_rows = 12;  ///< longer tables scroll, unless their page has room to spare
    void set_most_rows(int rows);
    /// Widens a column that has less than this, unless the user has given it a width.
    void make_room(int column, int width);
    /// The height with so many of its rows in view, if it has them.
    int height_with(int rows) const;
    /// The height of all rows, up to a limit.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    QAction* add(const QString& text, const QKeySequence& key, void (SpreadsheetView::*method)());
    void copy();
    void cut();
    void paste();
    void clear();
    void fill_down();
    void insert_row();
    void append_row();
    void remove_rows();
    void update_actions();
    void fit_columns(int first, int last);
    /// Narrows those that are wider than they need by more than `too_wide` (px).
    void shrink_columns(const std::set<int>& columns, int too_wide = 0);
    void give_back();
    /// Widths of a column of words.
    struct Words {
        int at, whole, least;
    };
    std::optional<Words> words(int column) const;
    void give_way();
    void move_down();
    void begin_row_below();
    void go_to(const QModelIndex& cell);

    SpreadsheetModel& model_;
    std::set<int> given_widths_;  ///< columns that the user has resized
    int most_rows_ = usual_rows;
    bool fitting_ = false;
    QTimer give_back_;
    bool tabs_on_ = false;  ///< the current cell is about to change by Tab
    int began_ = -1;        ///< column where Tab began to go along the current row; -1: it did not
    QAction* copy_;
    QAction* cut_;
    QAction* paste_;
    QAction* clear_;
    QAction* fill_down_;
    QAction* insert_row_;
    QAction* append_row_;
    QAction* remove_rows_;
};

}  // namespace covaria::ui
