// The rows of a budget come sorted by falling share.
#include "ui/models/budget_table_model.h"

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "ui/document/quantity_text.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void BudgetTableModel::set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                                  bool current) {
    result_ = std::move(result);
    output_ = output;
    current_result_ = current;
    rebuild();
}

void BudgetTableModel::set_units(const DisplayUnits& units) {
    units_ = units;
    rebuild();
}

void BudgetTableModel::set_digits(int digits) {
    digits_ = digits;
    rebuild();
}

void BudgetTableModel::rebuild() {
    std::vector<Column> columns;
    const bool shown = result_ && output_ < result_->budget.rows.size();
    if (shown) {
        add_component_columns(columns);
        add_contribution_columns(columns);
        add_origin_columns(columns);
    }
    set_contents(std::move(columns), shown ? result_->budget.rows[output_].size() : 0, current_result_);
}

QString BudgetTableModel::number(double value) const {
    return localized(format_significant(value, digits_));
}

void BudgetTableModel::add_component_columns(std::vector<Column>& columns) const {
    columns.push_back({tr("Input quantity"), {}, [this](std::size_t row) {
                           QStringList symbols;
                           for (const std::string& symbol : component(row).quantities)
                               symbols << to_qt(symbol_to_unicode(symbol));
                           return symbols.join(QStringLiteral(", "));
                       }});
    columns.push_back({QStringLiteral("u"), tr("Standard uncertainty of the component"),
                       [this](std::size_t row) {
                           return number(
                               component_unit(row).interval_from_si(component(row).standard_uncertainty));
                       },
                       [this](std::size_t row) { return component(row).standard_uncertainty; }});
    columns.push_back({tr("Unit"), tr("Of the component's u"),
                       [this](std::size_t row) { return to_qt(component_unit(row).display()); }});
}

void BudgetTableModel::add_contribution_columns(std::vector<Column>& columns) const {
    const auto sensitivity = [this](std::size_t row) {
        return output_unit().interval_from_si(row_at(row).sensitivity) *
               component_unit(row).interval_to_si(1.0);
    };
    columns.push_back({QStringLiteral("c"),
                       tr("Sensitivity coefficient, unit of the output quantity per unit of the component"),
                       [this, sensitivity](std::size_t row) { return number(sensitivity(row)); },
                       sensitivity});
    columns.push_back(
        {with_unit(QStringLiteral("|c|·u"), output_unit()), tr("Contribution to the standard uncertainty"),
         [this](std::size_t row) { return number(output_unit().interval_from_si(row_at(row).contribution)); },
         [this](std::size_t row) { return row_at(row).contribution; }});
    columns.push_back(
        {tr("Share / %"), tr("Of the variance, with its part of the covariances"),
         [this](std::size_t row) { return localized(format_decimals(100.0 * row_at(row).share, 1)); },
         [this](std::size_t row) { return row_at(row).share; }});
    bool one_at_a_time = false;
    for (const BudgetRow& row : result_->budget.rows[output_]) one_at_a_time |= row.one_at_a_time.has_value();
    if (!one_at_a_time) return;
    columns.push_back({with_unit(tr("u one at a time"), output_unit()),
                       tr("By Monte Carlo with every other component held"),
                       [this](std::size_t row) {
                           const auto& value = row_at(row).one_at_a_time;
                           return value ? number(output_unit().interval_from_si(*value)) : QString();
                       },
                       [this](std::size_t row) { return row_at(row).one_at_a_time.value_or(0.0); }});
}

void BudgetTableModel::add_origin_columns(std::vector<Column>& columns) const {
    columns.push_back(
        {to_qt(symbol_to_unicode("nu")), tr("Degrees of freedom"),
         [this](std::size_t row) { return degrees_of_freedom_text(component(row).degrees_of_freedom); },
         [this](std::size_t row) { return component(row).degrees_of_freedom; }});
    columns.push_back(
        {tr("Type"), tr("Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)"), [this](std::size_t row) {
             return component(row).type == EvaluationType::type_a ? QStringLiteral("A") : QStringLiteral("B");
         }});
    columns.push_back(
        {tr("Distribution"), {}, [this](std::size_t row) { return to_qt(component(row).distribution); }});
    columns.push_back(
        {tr("Component of uncertainty"), {}, [this](std::size_t row) { return to_qt(component(row).name); }});
    columns.push_back({tr("Origin"), tr("Where the figure comes from"),
                       [this](std::size_t row) { return to_qt(component(row).origin); }});
}

QVariant BudgetTableModel::extra(std::size_t row, std::size_t, int role) const {
    if (role == id_role) return to_qt(component(row).id);
    if (role == group_role) return to_qt(component(row).group);
    if (role == Qt::ToolTipRole) return to_qt(component(row).origin);
    return {};
}

}  // namespace covaria::ui
