// Correlation coefficients to two decimals, tinted as in the chart.
#include "ui/models/correlation_table_model.h"

#include <QColor>
#include <QGuiApplication>

#include "core/views/plots.h"
#include "core/views/result_columns.h"
#include "ui/models/roles.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

void CorrelationTableModel::set_result(std::shared_ptr<const UncertaintyResult> result,
                                       const std::string& group, bool current) {
    if (!result) return set_contents({}, {}, {}, current);
    Table table = correlation_table(*result, outputs_to_correlate(*result, group));
    std::vector<std::string> keys;
    for (std::size_t c = 1; c < table.columns.size(); ++c) keys.push_back(table.columns[c].key);
    set_contents(result, std::move(table), std::move(keys), current);
}

QVariant CorrelationTableModel::extra(std::size_t row, std::size_t column, int role) const {
    const int r = static_cast<int>(row), c = static_cast<int>(column);
    if (is_current() && (role == Qt::BackgroundRole || role == Qt::ForegroundRole)) {
        const QColor ground = Theme::of(QGuiApplication::palette())  // as in the chart
                                  .diverging(index(r, c).data(sort_role).toDouble());
        return role == Qt::BackgroundRole ? ground : Theme::text_on(ground);
    }
    if (role == Qt::ToolTipRole)
        return tr("Correlation of %1 with %2")
            .arg(headerData(r, Qt::Horizontal, role).toString(),
                 headerData(c, Qt::Horizontal, role).toString());
    return {};
}

}  // namespace covaria::ui
