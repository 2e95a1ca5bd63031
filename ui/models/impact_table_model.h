// The results that new figures of a certificate reach, before and after; or the files that used the old ones.
#pragma once

#include <QStringList>
#include <memory>

#include "core/impact/impact.h"
#include "ui/models/column_table_model.h"

namespace covaria::ui {

class ImpactTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;

    /// Shows the results; files alone where nothing was evaluated. Null: an empty table.
    void set_impact(std::shared_ptr<const Impact> impact, bool is_evaluated);
    /// Heads of columns that most people do without.
    static QStringList usually_hidden();
    /// Path of the file that a row is about.
    std::string file_of(int row) const;

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    std::shared_ptr<const Impact> impact_;
    bool is_evaluated_ = false;
};

}  // namespace covaria::ui
