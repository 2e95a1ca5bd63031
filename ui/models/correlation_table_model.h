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
    /// Outputs of one group, or all with an empty one. A null result empties the table.
    void set_result(std::shared_ptr<const UncertaintyResult> result, const std::string& group, bool current);

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;
    QString row_title(std::size_t row) const override { return titles_[row]; }

private:
    std::vector<QString> titles_;
    std::vector<QString> names_;
    Eigen::MatrixXd matrix_;
};

}  // namespace covaria::ui
