// A table field of a set-up as an editable spreadsheet.
#pragma once

#include <QAbstractTableModel>
#include <map>
#include <utility>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

/// All editing goes through the document; the model follows it, whoever edits. What cannot be understood is
/// kept and shown in its cell with the reason, but is not part of the project.
class SetupTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    SetupTableModel(Document& document, SetupAddress address, std::string field, QObject* parent = nullptr);
    /// With a schema that lives longer than the model, instead of the registered one.
    SetupTableModel(Document& document, SetupAddress address, const SetupSchema* schema, std::string field,
                    QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    bool insertRows(int row, int count, const QModelIndex& parent = {}) override;
    bool removeRows(int row, int count, const QModelIndex& parent = {}) override;

    /// Puts a block of cells at `at` as one undo step, adding rows as needed. Columns beyond the last are
    /// left out. Returns how many cells could not be understood.
    int paste(const QModelIndex& at, const QString& text);
    /// In each column the topmost selected cell is copied into the others.
    void fill_down(const QModelIndexList& cells);
    void clear(const QModelIndexList& cells);
    /// The whole table anew, as one undo step.
    void replace_table(const SetupTable& table, const QString& text);

    const FieldSpec* field() const;
    const SetupTable& table() const { return table_; }
    Unit unit(int column) const { return table_.units[static_cast<std::size_t>(column)]; }
    /// Numbers stay the same quantities. Ignored for a unit of another dimension.
    void set_unit(int column, const Unit& unit);

    /// The rows come from a CSV file beside the project and cannot be edited here.
    bool is_linked() const { return !table_.csv_file.empty(); }
    /// Takes the rows into the project, to be edited here.
    void embed();

    /// Cell of a JSON pointer relative to the field ("/rows/2/1", column by number or key); invalid if none.
    QModelIndex index_of_path(const std::string& path) const;

private:
    using CellPosition = std::pair<int, int>;  ///< row, column; column -1: the whole row
    struct Rejected {
        QString text;
        QString reason;               ///< empty: the cell was understood
        std::string instead_of = {};  ///< what the project has there
    };
    using Marks = std::map<CellPosition, Rejected>;
    void refresh();
    void change_rows(const SetupTable& next);
    void shift_rejected(int row, int count);
    void remember_rejected();
    void recall_rejected();
    std::string written(const CellPosition& at) const;
    void refresh_problems();
    SetupTable read() const;
    bool write(const QString& text, const std::function<void(SetupTable&)>& change);
    void set_cell(SetupTable& table, const CellPosition& at, const QString& text, Marks& marks) const;
    int take(const Marks& marks);
    const ColumnSpec& column(int index) const;
    /// A column of references as one of choices: the assets of the project that fit.
    ColumnSpec choosable(ColumnSpec column) const;
    QString complaint(const CellPosition& at) const;
    CellPosition position_of_path(const std::string& path) const;

    Document& document_;
    SetupAddress address_;
    std::string field_;
    const SetupSchema* schema_;
    SetupTable table_;
    Marks rejected_;
    std::map<CellPosition, QString> problems_;
};

}  // namespace covaria::ui
