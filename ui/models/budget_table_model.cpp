// The rows of a budget come sorted by falling share.
#include "ui/models/budget_table_model.h"

#include <algorithm>

#include "core/report/result_columns.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void BudgetTableModel::set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                                  bool current) {
    result_ = std::move(result);
    output_ = output;
    if (!result_ || output_ >= result_->budget.rows.size()) return set_contents({}, {}, {}, current);
    std::vector<std::string> keys = {"quantity",         "u", "unit", "sensitivity", "contribution",
                                     "share of variance"};
    const std::vector<BudgetRow>& rows = result_->budget.rows[output_];
    if (std::any_of(rows.begin(), rows.end(), [](const BudgetRow& row) { return row.one_at_a_time; }))
        keys.emplace_back("one at a time");
    keys.insert(keys.end(), {"degrees of freedom", "type", "distribution", "component", "origin"});
    set_contents(result_, budget_table(*result_, budget_places(*result_, output_)), std::move(keys), current);
}

QVariant BudgetTableModel::extra(std::size_t row, std::size_t, int role) const {
    const BudgetComponent& component =
        result_->budget.components[result_->budget.rows[output_][row].component];
    if (role == id_role) return to_qt(component.id);
    if (role == group_role) return to_qt(component.group);
    if (role == Qt::ToolTipRole) return to_qt(component.origin);
    return {};
}

}  // namespace covaria::ui
