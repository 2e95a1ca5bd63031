// The measurands of all analyses in one table, with what is required of them.
#pragma once

#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/propagation/requirements.h"
#include "ui/models/column_table_model.h"
#include "ui/run/run_backend.h"

namespace covaria::ui {

/// An analysis that has a result.
struct ShownAnalysis {
    std::string id, name;
    ResultPointer result;
    bool of_present = true;  ///< else it belongs to the project as it was
    QString state = {};      ///< in words
    std::vector<RequirementResult> verdicts = {};
};

class AllResultsModel : public ColumnTableModel {
    Q_OBJECT
public:
    using ColumnTableModel::ColumnTableModel;
    void set_analyses(std::vector<ShownAnalysis> analyses);
    /// Keeps only rows with all the words of `text` in analysis, symbol, name or group, and on request only
    /// those whose requirement is not met.
    void set_filter(const QString& text, bool only_not_met);

    struct Place {
        std::string analysis, group;
        std::size_t output = 0;
    };
    Place place_of(int row) const;

protected:
    QVariant extra(std::size_t row, std::size_t column, int role) const override;

private:
    struct Row {
        std::size_t analysis = 0, row = 0, output = 0;  ///< `row` of the table of that analysis
    };
    void rebuild();
    bool is_wanted(const ShownAnalysis& analysis, std::size_t output) const;
    /// The tables of the analyses with these outputs, one below the other.
    Table joined(const std::vector<std::vector<std::size_t>>& outputs) const;
    /// The coverage probability that all analyses share; nullopt: they have several.
    std::optional<double> coverage_probability() const;

    std::vector<ShownAnalysis> analyses_;
    std::vector<Row> rows_;
    QStringList words_;
    bool only_not_met_ = false;
};

}  // namespace covaria::ui
