// Correlation matrix of a result's output quantities.
#pragma once

#include <memory>

#include "core/result/uncertainty_result.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

class CorrelationTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;
    /// Shows outputs of one group, or all with an empty one. A null result empties the table.
    void set_result(std::shared_ptr<const UncertaintyResult> result, const std::string& group, bool current);

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;
    QVariant row_title(std::size_t row, int role) const override {
        return headerData(static_cast<int>(row), Qt::Horizontal, role);
    }
};

}  // namespace covaria::ui
