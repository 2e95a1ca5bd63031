// The rows of a budget come sorted by falling share.
#include "ui/models/budget_table_model.h"

#include <algorithm>

#include "ui/models/roles.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void BudgetTableModel::set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                                  bool current) {
    result_ = std::move(result);
    const bool is_known = result_ && output < result_->budget.rows.size();
    places_ = is_known ? places_that_count(*result_, output) : std::vector<BudgetPlace>();
    if (!is_known) return set_contents({}, {}, {}, current);
    std::vector<std::string> keys = {
        "label", "u", "unit", "sensitivity", "contribution", "share of variance"};
    const std::vector<BudgetRow>& rows = result_->budget.rows[output];
    if (std::any_of(rows.begin(), rows.end(), [](const BudgetRow& row) { return row.one_at_a_time; }))
        keys.emplace_back("one at a time");
    if (!result_->sobol.empty()) keys.insert(keys.end(), {"sobol", "sobol total"});
    keys.insert(keys.end(), {"degrees of freedom", "type", "distribution", "component"});
    const auto of_several = [this](const BudgetRow& row) {
        return result_->budget.components[row.component].quantities.size() > 1;
    };
    if (std::any_of(rows.begin(), rows.end(), of_several)) keys.emplace_back("quantity");
    keys.emplace_back("origin");
    set_contents(result_, budget_table(*result_, places_, language_of_window()), std::move(keys), current);
}

const BudgetComponent* BudgetTableModel::component(int row) const {
    if (row < 0 || row >= int(places_.size())) return nullptr;
    const BudgetPlace& place = places_[static_cast<std::size_t>(row)];
    return &result_->budget.components[result_->budget.rows[place.output][place.row].component];
}

/// Empty where the component has no index.
QString BudgetTableModel::standard_error(std::size_t row, const std::string& of_index) const {
    const QString figure = to_qt(to_unicode(text_of(of_index + " standard error", row)));
    if (figure.isEmpty()) return {};
    return tr("An estimate by sampling with a standard error of %1 %: S can exceed S total by chance")
        .arg(figure);
}

QVariant BudgetTableModel::extra(std::size_t row, std::size_t column, int role) const {
    const BudgetComponent& of = *component(int(row));
    const bool of_index = key(column) == "sobol" || key(column) == "sobol total";
    if (role == Qt::ToolTipRole && of_index) return standard_error(row, key(column));
    if (role == id_role) return to_qt(of.id);
    if (role == group_role) return to_qt(of.group);
    if (role == Qt::ToolTipRole) return to_qt(of.origin);
    return {};
}

}  // namespace covaria::ui
