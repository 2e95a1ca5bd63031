// A table field of a set-up as an editable spreadsheet.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "ui/document/document.h"
#include "ui/document/setup_address.h"
#include "ui/models/spreadsheet_model.h"

namespace covaria::ui {

/// All editing goes through the document; the model follows it, whoever edits. What cannot be understood is
/// kept and shown in its cell with the reason, but is not part of the project.
class SetupTableModel : public SpreadsheetModel {
    Q_OBJECT
public:
    SetupTableModel(Document& document, SetupAddress address, std::string field, QObject* parent = nullptr);
    /// Takes a schema that lives longer than the model, instead of the registered one.
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

    int paste(const QModelIndex& at, const QString& text) override;
    void fill_down(const QModelIndexList& cells) override;
    void clear(const QModelIndexList& cells) override;
    void remove_rows_at(const std::set<int>& rows) override;
    /// A text or number to put into a cell, or a text that is refused there.
    struct TypedCell {
        QString text = {};
        QString refused = {};               ///< why; empty: it is not
        std::optional<double> number = {};  ///< the number in the column's unit, instead of the text
    };
    /// Cells of a row by their columns as one undo step, or as a part of that with the same key (not empty),
    /// adding the row if need be. Returns how many could not be understood.
    /// `what`: for the list of steps, beside the name of the row.
    int write_row(int row, const std::map<int, TypedCell>& cells, const QString& merge_key = {},
                  const QString& what = {});
    /// The cells to write when a value is typed into a row of a table that states quantities: a unit behind
    /// the number becomes the row's where it has none yet; else the number is converted.
    std::map<int, TypedCell> cells_of_value(int row, const QString& text) const;
    /// Whether the cell's text could not be understood, and is kept beside the project.
    bool is_refused(int row, int column) const { return rejected_.contains({row, column}); }
    /// Why the statement of a cell has no effect: another analysis gives it. Empty: it has.
    QString taken_words(int row, int column) const;
    /// Replaces the whole table, as one undo step.
    void replace_table(const SetupTable& table, const QString& text);

    const FieldSpec* field() const;
    const SetupTable& table() const { return table_; }
    Unit unit(int column) const { return table_.units[static_cast<std::size_t>(column)]; }
    /// Changes the unit of a column; numbers stay the same quantities. Ignored for another dimension.
    void set_unit(int column, const Unit& unit);

    bool is_linked() const override { return !table_.csv_file.empty(); }
    /// Takes the rows into the project, to be edited here.
    void embed();

    /// Cell of a JSON pointer relative to the field ("/rows/2/1", column by number or key); invalid if none.
    QModelIndex index_of_path(const std::string& path) const;

private:
    using CellPosition = std::pair<int, int>;  ///< row, column; column -1: the whole row
    struct Rejected {
        QString text;
        QString reason;               ///< empty: the cell was understood
        std::string instead_of = {};  ///< the project's cell when it was typed
        bool operator==(const Rejected&) const = default;
    };
    using Marks = std::map<CellPosition, Rejected>;
    void refresh();
    void change_rows(const SetupTable& next);
    void shift_rejected(int row, int count);
    void remember_rejected();
    TextPlace place_of(const CellPosition& at) const;
    UnreadTexts::Texts kept_texts() const;
    void recall_rejected();
    std::string written(const CellPosition& at) const;
    void refresh_problems();
    void refresh_taken();
    QString name_of_row(int row) const;
    SetupTable read() const;
    std::vector<std::vector<int>> decimals_of_table() const;
    std::string written_out(const CellPosition& at, double number) const;
    bool write(const QString& text, const std::function<void(SetupTable&)>& change,
               const QString& merge_key = {});
    void set_cell(SetupTable& table, const CellPosition& at, const QString& text, Marks& marks) const;
    int take(const Marks& marks);
    const ColumnSpec& column(int index) const;
    /// A column of references as one of choices: the assets of the project that fit.
    ColumnSpec choosable(ColumnSpec column) const;
    QString complaint(const CellPosition& at) const;
    QString tooltip(const CellPosition& at) const;
    CellPosition position_of_path(const std::string& path) const;

    Document& document_;
    SetupAddress address_;
    std::string field_;
    const SetupSchema* schema_;
    SetupTable table_;
    std::vector<std::vector<int>> decimals_;  ///< shared ones, by column and row
    Marks rejected_;
    UnreadTexts::Texts seen_;  ///< the document's texts when `rejected_` was last compared with them
    std::map<CellPosition, QString> problems_;
    std::map<int, QString> taken_;  ///< rows that a link of the analysis replaces, with its words
};

}  // namespace covaria::ui
