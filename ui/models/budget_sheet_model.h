// The budget of an analysis as it is typed and as it comes out, in one table in the form of EA-4/02: what is
// stated of each quantity beside what it contributes to an output.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/quantity/statement_text.h"
#include "core/result/uncertainty_result.h"
#include "core/text/cell.h"
#include "ui/models/setup_table_model.h"
#include "ui/models/sheet_figures.h"

namespace covaria::ui {

/// The rows are those of the table of the set-up that states quantities (FieldSpec::states_quantities), and
/// one more to type a new one into. What is stated is edited through `sheet()`, so undo, problems and texts
/// that cannot be read are its own; the rest is read from a result.
class BudgetSheetModel : public SpreadsheetModel {
    Q_OBJECT
public:
    /// Sections in the order of the columns.
    enum Section {
        symbol,
        name,
        estimate,
        unit,
        stated,
        distribution,
        type,
        nu,
        u,
        c,
        contribution,
        share,
        source
    };
    static constexpr int sections = source + 1;

    BudgetSheetModel(Document& document, const SetupAddress& address, const FieldSpec& field,
                     QObject* parent = nullptr);

    /// A null result, or an output it does not have, leaves the computed cells empty.
    void set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output, bool current);
    /// Sets the units of results, which computed cells have.
    void set_units(const DisplayUnits& units);
    void set_digits(int digits) { digits_ = digits; }  ///< significant ones of u, with the next result
    SetupTableModel& sheet() { return sheet_; }

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
    /// Passes over u, which follows, and a unit typed behind the estimate: the statement is typed next.
    bool is_passed_over(const QModelIndex& cell) const override {
        return cell.column() == u || (cell.column() == unit && cell.row() == typed_with_unit_);
    }
    bool is_linked() const override { return sheet_.is_linked(); }

    static bool is_computed(int section);
    /// Symbol of the quantity that the row states; empty: none yet.
    std::string symbol_of(int row) const;
    /// Id of the component that the row states in the result shown; empty: none.
    std::string component_of(int row) const;

private:
    using Cells = std::map<int, SetupTableModel::TypedCell>;
    void follow_sheet();
    bool is_new_row(int row) const { return row == sheet_.rowCount(); }
    int column(const char* key) const;
    /// Column of the set-up's table; -1: the section has none of its own.
    int column_of(int section) const;
    QVariant computed(int row, int section, int role) const;
    /// As a part of the variance, without its sign.
    double share_of(std::size_t row) const;
    QVariant of_sheet(int row, int section, int role) const;
    QVariant stated_cell(int row, int role) const;
    QString stated_words(int row, bool typeset) const;
    void read_again(int row);
    bool state_u(int row, const QString& text);
    bool is_typed(const QModelIndex& cell) const;
    Unit unit_of(int row) const;
    /// Text of a cell; empty if the cell is.
    std::string text_at(int row, const char* key) const;
    std::optional<double> number_at(int row, const char* key) const;
    /// The cells that typing `text` into a section of a row writes there and beside it.
    Cells cells_for(int row, int section, const QString& text) const;
    Cells cells_of_statement(int row, const QString& text) const;
    /// A new key: edits that are written with the same key are one undo step.
    QString next_step();
    /// Writes the cells of `cells_for`, and the observations that a statement lists. Returns how many could
    /// not be understood.
    int write(int row, int section, const QString& text, const QString& step);
    void take_observations(int row, const QString& text, const QString& step);
    Result<TypedStatement> read_typed(int row, const QString& text) const;
    Result<TypedStatement> read_in(const QString& text, const Unit& of_row) const;
    std::optional<Unit> unit_of_list(int row, const QString& text) const;
    /// Follows the observations: they have a table of their own, which others can edit too.
    void follow_observations();
    const std::vector<double>& observed(const std::string& of) const;

    Document& document_;
    SetupAddress address_;
    SetupValue observations_;  ///< the ones that are shown
    /// Observations of the rows shown, by symbol: cells are painted often, and the table can be long.
    mutable std::map<std::string, std::vector<double>> observed_;
    const FieldSpec& field_;
    SetupTableModel sheet_;
    SheetFigures figures_;  ///< the figures computed for the rows
    std::shared_ptr<const UncertaintyResult> result_;
    std::size_t output_ = 0;
    double largest_share_ = 0.0;  ///< of the rows, when the result came
    DisplayUnits units_;
    int digits_ = 2;
    bool current_ = true;
    int steps_ = 0;
    int typed_with_unit_ = -1;  ///< row whose estimate was typed last, with a unit behind it
};

}  // namespace covaria::ui
