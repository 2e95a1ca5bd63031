// Correlation coefficients to two decimals, tinted by magnitude.
#include "ui/models/correlation_table_model.h"

#include <QColor>
#include <cmath>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "ui/models/number_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void CorrelationTableModel::set_result(std::shared_ptr<const UncertaintyResult> result,
                                       const std::string& group, bool current) {
    std::vector<std::size_t> shown;
    titles_.clear();
    names_.clear();
    for (std::size_t i = 0; result && i < result->outputs.size(); ++i) {
        const OutputQuantity& quantity = result->outputs[i].quantity;
        if (!group.empty() && quantity.group != group) continue;
        shown.push_back(i);
        const QString symbol = to_qt(symbol_to_unicode(quantity.symbol));
        titles_.push_back(group.empty() && !quantity.group.empty() ? symbol + ", " + to_qt(quantity.group)
                                                                   : symbol);
        names_.push_back(to_qt(quantity.name));
    }
    const auto size = static_cast<Eigen::Index>(shown.size());
    Eigen::MatrixXd covariance(size, size);
    for (Eigen::Index r = 0; r < size; ++r)
        for (Eigen::Index c = 0; c < size; ++c)
            covariance(r, c) =
                result->covariance(static_cast<Eigen::Index>(shown[static_cast<std::size_t>(r)]),
                                   static_cast<Eigen::Index>(shown[static_cast<std::size_t>(c)]));
    matrix_ = correlation_of(covariance);
    std::vector<Column> columns;
    for (std::size_t c = 0; c < shown.size(); ++c) {
        const auto value = [this, c](std::size_t row) {
            return matrix_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(c));
        };
        columns.push_back({titles_[c], names_[c],
                           [value](std::size_t row) { return localized(format_decimals(value(row), 2)); },
                           value});
    }
    set_contents(std::move(columns), shown.size(), current);
}

QVariant CorrelationTableModel::extra(std::size_t row, std::size_t column, int role) const {
    const double r = matrix_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    if (role == Qt::BackgroundRole && row != column) {
        QColor tint = r < 0.0 ? QColor(0, 114, 178) : QColor(213, 94, 0);
        tint.setAlphaF(static_cast<float>(0.45 * std::min(1.0, std::abs(r))));
        return tint;
    }
    if (role == Qt::ToolTipRole) return tr("Correlation of %1 with %2").arg(names_[row], names_[column]);
    return {};
}

}  // namespace covaria::ui
