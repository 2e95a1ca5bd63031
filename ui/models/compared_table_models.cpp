#include "ui/models/compared_table_models.h"

#include <algorithm>

#include "core/views/comparison_columns.h"
#include "ui/models/roles.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

const OutputQuantity& ComparedResultsModel::quantity_of(std::size_t output) const {
    const ComparedOutput& at = comparison_->outputs[output];
    const OutputResult* after = comparison_->output_after(at);
    return (after ? after : comparison_->output_before(at))->quantity;
}

void ComparedResultsModel::set_comparison(ComparisonPointer comparison, const std::string& group,
                                          bool current) {
    comparison_ = std::move(comparison);
    shown_.clear();
    if (!comparison_) return set_contents({}, {}, {}, current);
    for (std::size_t i = 0; i < comparison_->outputs.size(); ++i)
        if (group.empty() || quantity_of(i).group == group) shown_.push_back(i);
    set_contents(comparison_, compared_results_table(*comparison_, shown_),
                 {"group", "symbol", "U before", "U after", "change of U", "unit", "name", "estimate before",
                  "estimate after", "change of estimate", "u before", "u after", "k before", "k after", "in"},
                 current);
}

int ComparedResultsModel::row_of(std::size_t output) const {
    const auto found = std::find(shown_.begin(), shown_.end(), output);
    return found == shown_.end() ? -1 : static_cast<int>(found - shown_.begin());
}

QVariant ComparedResultsModel::extra(std::size_t row, std::size_t, int role) const {
    const OutputQuantity& quantity = quantity_of(shown_[row]);
    if (role == group_role) return to_qt(quantity.group);
    if (role == id_role) return to_qt(quantity.symbol);
    return {};
}

void ComparedBudgetModel::set_comparison(ComparisonPointer comparison, std::size_t output, bool current) {
    if (!comparison) return set_contents({}, {}, {}, current);
    Table table =
        compared_budget_table(*comparison, compared_places(*comparison, output), language_of_window());
    set_contents(
        std::move(comparison), std::move(table),
        {"label", "change of variance", "what", "component", "contribution before", "contribution after",
         "u before", "u after", "unit", "share before", "share after", "origin"},
        current);
}

}  // namespace covaria::ui
