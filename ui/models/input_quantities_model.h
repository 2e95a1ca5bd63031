// The input quantities of an analysis with the user's edits; those that other analyses give come last.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/made/prepared_analysis.h"
#include "core/text/cell.h"
#include "ui/document/document.h"

namespace covaria::ui {

class InputQuantitiesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        symbol_column,
        name_column,
        estimate_column,  ///< editable
        unit_column,
        uncertainty_column,
        components_column,
        held_column,  ///< check box
        column_count
    };
    explicit InputQuantitiesModel(Document& document, QObject* parent = nullptr);

    /// The analysis as it was last prepared; null empties the table.
    void set_analysis(std::shared_ptr<const PreparedAnalysis> analysis);
    const std::shared_ptr<const PreparedAnalysis>& analysis() const { return analysis_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    /// Gives the quantity back what the model says.
    void reset_edits(int row);
    bool is_edited(int row) const;
    int row_of(const std::string& symbol) const;
    /// Whether its value is an output of another analysis: nothing of it is edited here.
    bool is_linked(int row) const { return static_cast<std::size_t>(row) >= own_.size(); }
    const InputQuantity& quantity(int row) const {
        const auto i = static_cast<std::size_t>(row);
        return is_linked(row) ? linked_[i - own_.size()] : analysis_->inputs.quantities[own_[i]];
    }

private:
    void list_rows();
    double estimate(int row) const;
    double standard_uncertainty(int row) const;
    QString linked_text(int row) const;
    QString text(int row, int column) const;
    Text typeset(int row, int column) const;
    Text typeset_linked(int row, int column) const;
    QString estimate_text(int row) const;
    QString shown_estimate(int row) const;
    QString components_text(int row) const;
    QVariant sort_value(int row, int column) const;
    QVariant row_data(int row, int role) const;
    bool set_estimate(int row, const QString& text);
    bool set_held(int row, bool held);

    Document& document_;
    std::shared_ptr<const PreparedAnalysis> analysis_;
    Table table_;                        ///< a row for each quantity that is not linked
    std::vector<std::size_t> own_;       ///< indices of the quantities that are not upstream's
    std::vector<InputQuantity> linked_;  ///< the quantities of `analysis_->linked`
};

}  // namespace covaria::ui
