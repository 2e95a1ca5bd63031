// The questions that a spreadsheet view asks of a model beyond cells.
#pragma once

#include <QAbstractTableModel>
#include <QModelIndexList>
#include <QString>
#include <set>

namespace covaria::ui {

class SpreadsheetModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;
    /// Puts a block of cells at `at` as one undo step, adding rows as needed. Columns beyond the last are
    /// left out. Returns how many cells could not be understood.
    virtual int paste(const QModelIndex& at, const QString& text) = 0;
    /// Copies the topmost selected cell of each column into the others of it.
    virtual void fill_down(const QModelIndexList& cells) = 0;
    virtual void clear(const QModelIndexList& cells) = 0;
    /// Removes them as one undo step.
    virtual void remove_rows_at(const std::set<int>& rows) = 0;
    /// The rows come from a file beside the project and cannot be edited here.
    virtual bool is_linked() const = 0;
    /// Whether Tab passes over the cell: it was filled together with the cell before.
    virtual bool is_passed_over(const QModelIndex&) const { return false; }
};

}  // namespace covaria::ui
