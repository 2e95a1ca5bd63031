#include "ui/models/sheet_figures.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/views/result_columns.h"

namespace covaria::ui {
namespace {

/// The row of a table that a JSON pointer names: "/quantities/rows/3".
std::optional<std::size_t> row_of(const std::string& source, const std::string& table) {
    const std::string before = "/" + table + "/rows/";
    if (!source.starts_with(before)) return std::nullopt;
    std::size_t row = 0;
    const auto [end, status] =
        std::from_chars(source.data() + before.size(), source.data() + source.size(), row);
    return status == std::errc() ? std::optional(row) : std::nullopt;
}

}  // namespace

DisplayUnits units_of_contributions(const OutputResult& output, const DisplayUnits& units) {
    DisplayUnits best;
    best.choose(readable_unit(output.first_order.standard_uncertainty, units.of(output.quantity.unit)));
    return best;
}

void SheetFigures::follow(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                          const std::string& key) {
    result_ = std::move(result);
    output_ = output;
    lines_.clear();
    components_.clear();
    budget_ = table_ = {};
    if (!result_) return;
    const auto at = [](auto& list, std::size_t row) -> auto& {
        if (list.size() <= row) list.resize(row + 1);
        return list[row];
    };
    for (const InputQuantity& quantity : result_->inputs->quantities) {
        if (!quantity.analysis.empty()) continue;
        for (const Share& part : quantity.shares)
            if (const auto row = row_of(result_->inputs->components[part.component].source, key))
                at(components_, *row) = part.component;
    }
    budget_ = budget_table(*result_, budget_places(*result_, output_));
    const std::vector<BudgetRow>& rows = result_->budget.rows[output_];
    lines_.resize(components_.size());
    for (std::size_t row = 0; row < components_.size(); ++row)
        for (std::size_t line = 0; components_[row] && line < rows.size(); ++line)
            if (rows[line].component == *components_[row]) lines_[row] = line;
    make_table();
}

void SheetFigures::move(int first, int count) {
    const auto move_in = [&](auto& of_rows) {
        const auto size = static_cast<int>(of_rows.size());
        const auto at = of_rows.begin() + std::min(first, size);
        if (count > 0 && first <= size)
            of_rows.insert(at, static_cast<std::size_t>(count), {});
        else if (count < 0)
            of_rows.erase(at, of_rows.begin() + std::min(first - count, size));
    };
    move_in(components_);
    move_in(lines_);
}

const BudgetComponent* SheetFigures::component(std::size_t row) const {
    const bool known = result_ && row < components_.size() && components_[row];
    return known ? &result_->budget.components[*components_[row]] : nullptr;
}

/// Makes a row for each row of the sheet that states a component. Stated figures stay in the row's unit.
void SheetFigures::make_table() {
    using Scale = Measured::Scale;
    table_ = {"sheet", "", components_.size()};
    const auto add = [this](const char* key, auto get) -> Column& {
        return table_.add(key, [this, get](std::size_t row) -> Cell {
            const BudgetComponent* of = component(row);
            return of ? get(row, *of) : Cell();
        });
    };
    using C = const BudgetComponent&;
    add("estimate", [this](std::size_t row, C of) {
        return Measured{of.estimate, Scale::value, unit_of_row_(row)};
    }).input_of("u of row");
    add("u of row", [this](std::size_t row, C of) {
        return Measured{of.standard_uncertainty, Scale::interval, unit_of_row_(row)};
    }).uncertainty();
    add("u",
        [](std::size_t, C of) {
            return Measured{of.standard_uncertainty, Scale::interval, of.unit};
        })
        .uncertainty()
        .of_row({"estimate", "u"});
    add("distribution", [](std::size_t, C of) -> Cell { return of.distribution; }).of_own_words();
    add("sensitivity", [this](std::size_t row, C of) { return sensitivity(row, of); })
        .figure_no_fewer(sensitivity_digits)
        .with_unit();
    for (const char* key : {"type", "degrees of freedom", "contribution", "share of variance"}) {
        Column shown = budget_[key];
        shown.cell = add(key, [this, key](std::size_t row, C of) {
                         return lines_[row] ? budget_.cell(*lines_[row], key) : without_influence(key, of);
                     }).cell;
        table_.columns.back() = std::move(shown);
    }
}

/// Sensitivity in the same prefix above and below the line: terms of a sum have c = 1. Else in the unit of
/// the result in which it has one to three digits before the point, per unit of the row: "-575 nm/K".
Cell SheetFigures::sensitivity(std::size_t row, const BudgetComponent& component) const {
    if (!lines_[row]) return std::string("0");
    const Unit& of_result = units_.of(result_->outputs[output_].quantity.unit);
    const double si = result_->budget.rows[output_][*lines_[row]].sensitivity;
    if (of_result.dimension() == component.unit.dimension()) return Quantity{si, Unit()};
    const double of_one = component.unit.interval_to_si(si);
    const Unit shown = readable_unit(of_one, of_result);
    return Quantity{shown.interval_from_si(of_one), quotient(shown, component.unit)};
}

/// Cell of a component that the result does not depend on, to first order.
Cell SheetFigures::without_influence(std::string_view key, const BudgetComponent& component) const {
    if (key == "type") return std::string(component.type == EvaluationType::type_a ? "A" : "B");
    if (key == "degrees of freedom") return Measured{component.degrees_of_freedom};
    const bool has_variance = result_->outputs[output_].first_order.standard_uncertainty > 0.0;
    return std::string(key == "share of variance" && !has_variance ? "–" : "0");
}

}  // namespace covaria::ui
