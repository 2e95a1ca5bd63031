// The output quantities of a result: estimate, u, effective degrees of freedom, k, U, interval, first order
// beside; what is required of them is typed here.
#pragma once

#include <QStringList>
#include <memory>

#include "core/result/uncertainty_result.h"
#include "ui/models/column_table_model.h"
#include "ui/models/requirement_cells.h"

namespace covaria::ui {

class ResultTableModel : public ColumnTableModel {
    Q_OBJECT
public:
    enum class Interval { symmetric, shortest };
    using ColumnTableModel::ColumnTableModel;

    /// Target and limits, which are typed here.
    RequirementCells& requirements() { return requirements_; }
    /// A null result empties the table. `verdicts` on this result; none: no column tells whether they are
    /// met.
    void set_result(std::shared_ptr<const UncertaintyResult> result, bool current,
                    std::vector<RequirementResult> verdicts = {});
    /// Shows outputs of one group only; empty: all.
    void set_group(const std::string& group);
    void set_interval(Interval interval);
    /// Keeps only rows with all the words of `text` in symbol, name or group, and on request only those whose
    /// requirement is not met.
    void set_filter(const QString& text, bool only_not_met);

    /// Index among the result's outputs.
    std::size_t output_of(int row) const { return shown_[static_cast<std::size_t>(row)]; }
    int row_of(std::size_t output) const;  ///< -1 when it is not shown

    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    /// Takes a quantity as it is typed; a text that is none stays in its cell, marked.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    void rebuild();
    /// Null: nothing is typed in the cell's column.
    const RequirementField* field_of(const QModelIndex& index) const;
    std::vector<std::string> keys() const;
    QString deviations(std::size_t row) const;
    bool is_wanted(std::size_t output) const;

    std::shared_ptr<const UncertaintyResult> result_;
    bool current_result_ = true;
    std::vector<std::size_t> shown_;
    std::string group_;
    Interval interval_ = Interval::symmetric;
    std::vector<RequirementResult> verdicts_;
    QStringList words_;
    bool only_not_met_ = false;
    RequirementCells requirements_;
};

}  // namespace covaria::ui
