// The input quantities of an analysis with the user's edits.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/made/prepared_analysis.h"
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

    /// Back to what the model says.
    void reset_edits(int row);
    bool is_edited(int row) const;
    int row_of(const std::string& symbol) const;

private:
    const InputQuantity& quantity(int row) const {
        return analysis_->inputs.quantities[static_cast<std::size_t>(row)];
    }
    QString text(int row, int column) const;
    QString estimate_text(int row) const;
    QString components_text(int row) const;
    QVariant sort_value(int row, int column) const;
    QVariant row_data(int row, int role) const;
    bool set_estimate(int row, const QString& text);
    bool set_held(int row, bool held);

    Document& document_;
    std::shared_ptr<const PreparedAnalysis> analysis_;
};

}  // namespace covaria::ui
