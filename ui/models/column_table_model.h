// A read-only table described column by column; base of the tables of results.
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <functional>
#include <vector>

namespace covaria::ui {

class ColumnTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    /// The text, `sort_role`, alignment, `extra`, and a grey pen while the contents are out of date.
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    /// False: the result shown belongs to an earlier state of the project.
    bool is_current() const { return current_; }

protected:
    struct Column {
        QString title;
        QString help = {};
        std::function<QString(std::size_t row)> text;
        std::function<double(std::size_t row)> number = {};  ///< for sorting; empty: a column of text
    };
    /// Same shape as before: views keep their selection and scroll position.
    void set_contents(std::vector<Column> columns, std::size_t rows, bool current);
    /// Other roles of a cell.
    virtual QVariant extra(std::size_t row, std::size_t column, int role) const;
    virtual QString row_title(std::size_t row) const;

private:
    std::vector<Column> columns_;
    std::size_t rows_ = 0;
    bool current_ = true;
};

}  // namespace covaria::ui
