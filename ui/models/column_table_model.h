// A read-only table: some columns of a table of the core, in the units and with the digits of this view.
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <string>
#include <vector>

#include "core/text/cell.h"
#include "ui/models/number_words.h"
#include "ui/theme/document_language.h"

namespace covaria::ui {

class ColumnTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    /// The text, `typeset_role`, `sort_role`, `exact_role`, alignment, `extra`, and a grey pen while the
    /// contents are out of date.
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    /// False: the result shown belongs to an earlier state of the project.
    bool is_current() const { return current_; }
    void set_units(const DisplayUnits& units);
    const DisplayUnits& units() const { return view_.units; }
    void set_digits(int digits);  ///< significant digits of uncertainties

    /// A table for a file, of these rows and columns shown, in `units()`; it lives no longer than the
    /// contents.
    Table file_table(const std::vector<int>& rows, const std::vector<int>& columns) const;

protected:
    /// Shows the columns of `table` with these keys. Where the shape is as before, views keep selection and
    /// scroll position. `owner` is kept: the table reads it.
    void set_contents(std::shared_ptr<const void> owner, Table table, std::vector<std::string> keys,
                      bool current);
    /// Other roles of a cell.
    virtual QVariant extra(std::size_t row, std::size_t column, int role) const;
    virtual QVariant row_title(std::size_t row, int role) const;
    const std::string& key(std::size_t column) const { return keys_[column]; }
    /// Text of a column of the table, which need not be shown.
    Text text_of(const std::string& column, std::size_t row) const { return shown(table_[column], row); }

private:
    const Column& column(int section) const { return table_[keys_[static_cast<std::size_t>(section)]]; }
    /// Head of a column in the language of the window.
    Text head(const Column& column) const;
    Text shown(const Column& column, std::size_t row) const;
    void tell();
    /// View with numbers as the window writes them now.
    TableView view() const { return {view_.units, view_.digits, language_of_window()}; }

    std::shared_ptr<const void> owner_;
    Table table_;
    std::vector<std::string> keys_;
    TableView view_{{}, 2, {}};
    bool current_ = true;
};

}  // namespace covaria::ui
