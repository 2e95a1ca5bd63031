// The grid points of a study: values of the axes, uncertainties, remarks.
#pragma once

#include <memory>

#include "core/result/study_result.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

class StudyTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;
    /// Null empties the table.
    void set_study(std::shared_ptr<const StudyResult> study, bool current);

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    std::shared_ptr<const StudyResult> study_;
};

}  // namespace covaria::ui
