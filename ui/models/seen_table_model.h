// Stated figures beside what the residuals see of them, a row each.
#pragma once

#include <memory>

#include "core/evidence/seen.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

class SeenTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    enum Role {
        /// Interval of the factor: low end, factor, high end and evidence::Verdict, as a QList<double>.
        interval_role = Qt::UserRole + 40,
        verdict_role,  ///< evidence::Verdict as int
    };
    using ColumnTableModel::ColumnTableModel;

    /// Null: an empty table.
    void set_seen(std::shared_ptr<const evidence::RedundantReadings> readings,
                  std::shared_ptr<const evidence::Seen> seen);

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    std::shared_ptr<const evidence::Seen> seen_;
};

}  // namespace covaria::ui
