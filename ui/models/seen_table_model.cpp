#include "ui/models/seen_table_model.h"

#include "core/views/seen_table.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// The upper end of the interval is in the mark of the lower one.
bool is_shown(const Column& column) {
    return column.key != "factor_high" && column.key != "degrees_of_freedom";
}

}  // namespace

void SeenTableModel::set_seen(std::shared_ptr<const evidence::RedundantReadings> readings,
                              std::shared_ptr<const evidence::Seen> seen) {
    seen_ = seen && readings ? std::move(seen) : nullptr;
    Table table = seen_ ? seen_table(*readings, *seen_, language_of_window()) : Table{"seen", {}};
    for (Column& column : table.columns)
        if (column.key == "factor_low") column.title = running_text(to_std(tr("interval of the factor")));
    std::vector<std::string> shown;
    for (const Column& column : table.columns)
        if (is_shown(column)) shown.push_back(column.key);
    set_contents(readings, std::move(table), std::move(shown), true);
}

QVariant SeenTableModel::extra(std::size_t row, std::size_t column, int role) const {
    if (!seen_ || row >= seen_->figures.size()) return {};
    const evidence::SeenFigure& figure = seen_->figures[row];
    if (role == verdict_role && key(column) == "verdict") return int(figure.verdict);
    if (role == interval_role && key(column) == "factor_low" && figure.degrees_of_freedom > 0.0)
        return QVariant::fromValue(
            QList<double>{figure.low, figure.factor, figure.high, double(int(figure.verdict))});
    return {};
}

}  // namespace covaria::ui
