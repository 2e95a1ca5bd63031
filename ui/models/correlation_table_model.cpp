// Correlation coefficients to two decimals, tinted by magnitude.
#include "ui/models/correlation_table_model.h"

#include <QColor>
#include <cmath>

#include "core/report/plots.h"
#include "core/report/result_columns.h"
#include "ui/models/roles.h"

namespace covaria::ui {

void CorrelationTableModel::set_result(std::shared_ptr<const UncertaintyResult> result,
                                       const std::string& group, bool current) {
    if (!result) return set_contents({}, {}, {}, current);
    Table table = correlation_table(*result, outputs_to_correlate(*result, group));
    std::vector<std::string> keys;
    for (std::size_t c = 1; c < table.columns.size(); ++c) {
        table.columns[c].rule.decimals = 2;
        keys.push_back(table.columns[c].key);
    }
    set_contents(result, std::move(table), std::move(keys), current);
}

QVariant CorrelationTableModel::extra(std::size_t row, std::size_t column, int role) const {
    const int r = static_cast<int>(row), c = static_cast<int>(column);
    if (role == Qt::BackgroundRole && r != c) {
        const double coefficient = index(r, c).data(sort_role).toDouble();
        QColor tint = coefficient < 0.0 ? QColor(0, 114, 178) : QColor(213, 94, 0);
        tint.setAlphaF(static_cast<float>(0.45 * std::min(1.0, std::abs(coefficient))));
        return tint;
    }
    if (role == Qt::ToolTipRole)
        return tr("Correlation of %1 with %2")
            .arg(headerData(r, Qt::Horizontal, role).toString(),
                 headerData(c, Qt::Horizontal, role).toString());
    return {};
}

}  // namespace covaria::ui
