// The uncertainty budget.
#include <memory>

#include "core/report/report_parts.h"
#include "core/report/result_columns.h"

namespace covaria {
namespace {

using Scale = Measured::Scale;
using Places = std::shared_ptr<const std::vector<BudgetPlace>>;

/// A line of a budget and what it is about.
struct BudgetLine {
    const OutputQuantity& output;
    const BudgetRow& row;
    const BudgetComponent& component;
};

template <class Get>
std::function<Cell(std::size_t)> of_line(const UncertaintyResult& result, const Places& places, Get get) {
    return [&result, places, get](std::size_t i) -> Cell {
        const auto [output, at] = (*places)[i];
        const BudgetRow& row = result.budget.rows[output][at];
        return get(BudgetLine{result.outputs[output].quantity, row, result.budget.components[row.component]});
    };
}

/// In the component's unit, or with that of its quantity: -49.28° where u is in seconds of arc. The estimate
/// of a component that several quantities share would be that of one of them.
Cell estimate_cell(const BudgetLine& line) {
    const BudgetComponent& c = line.component;
    const Unit& unit = c.quantity_unit;
    if (c.quantities.size() > 1) return {};
    if (unit == c.unit || !(unit.dimension() == c.unit.dimension()))
        return Measured{c.estimate, Scale::value, c.unit, {}};
    const std::string number = typeset_number(
        format_to_match(unit.from_si(c.estimate), unit.interval_from_si(c.standard_uncertainty)));
    return number + (unit == Unit::of("deg") ? "" : "\u00a0") + unit.display();
}

Cell interval(double si, const Unit& unit) {
    return Measured{si, Scale::interval, unit, {}};
}

/// The unit that all places have in common.
std::optional<Unit> common_unit(const UncertaintyResult& result, const std::vector<BudgetPlace>& places) {
    for (const BudgetPlace& place : places)
        if (place.output != places.front().output) return std::nullopt;
    if (places.empty()) return std::nullopt;
    return result.outputs[places.front().output].quantity.unit;
}

}  // namespace

std::vector<BudgetPlace> budget_places(const UncertaintyResult& result, std::size_t output) {
    std::vector<BudgetPlace> places;
    if (output < result.budget.rows.size())
        for (std::size_t i = 0; i < result.budget.rows[output].size(); ++i) places.push_back({output, i});
    return places;
}

Table budget_table(const UncertaintyResult& result, std::vector<BudgetPlace> at) {
    const std::optional<Unit> unit = common_unit(result, at);
    const auto places = std::make_shared<const std::vector<BudgetPlace>>(std::move(at));
    Table table{"budget", "Uncertainty budgets", {}, places->size()};
    using L = const BudgetLine&;
    const auto add = [&](Column column, auto get) {
        column.cell = of_line(result, places, get);
        table.columns.push_back(std::move(column));
    };
    add({.key = "group"}, [](L l) -> Cell { return l.output.group; });
    add({.key = "output"}, [](L l) -> Cell { return Symbols{l.output.symbol}; });
    add({.key = "output unit"}, [](L l) -> Cell { return l.output.unit; });
    add({.key = "quantity", .head = "Symbol", .symbols = true, .title = "Input quantity"},
        [](L l) -> Cell { return l.component.quantities; });
    add({.key = "component", .title = "Component of uncertainty"},
        [](L l) -> Cell { return l.component.name; });
    add({.key = "component in words", .head = "Component"},
        [](L l) -> Cell { return l.component.name + (l.component.held ? " (held)" : ""); });
    add({.key = "id"}, [](L l) -> Cell { return l.component.id; });
    add({.key = "unit", .head = "Unit", .title = "Unit", .help = "Of the component's u"},
        [](L l) -> Cell { return l.component.unit; });
    add({.key = "estimate", .head = "x_i", .is_symbol = true, .rule = {.match = "u", .input = true}},
        estimate_cell);
    add({.key = "u",
         .head = "u(x_i)",
         .is_symbol = true,
         .title = "u",
         .help = "Standard uncertainty of the component",
         .rule = {.digits = 3}},
        [](L l) { return interval(l.component.standard_uncertainty, l.component.unit); });
    add({.key = "distribution", .head = "Distribution", .title = "Distribution"},
        [](L l) -> Cell { return l.component.distribution; });
    add({.key = "type",
         .head = "Type",
         .title = "Type",
         .help = "Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)"},
        [](L l) -> Cell { return report_parts::type_text(l.component.type); });
    add({.key = "degrees of freedom",
         .head = "nu_i",
         .is_symbol = true,
         .title = symbol_text("nu"),
         .help = "Degrees of freedom",
         .rule = {.degrees_of_freedom = true}},
        [](L l) { return interval(l.component.degrees_of_freedom, Unit{}); });
    add({.key = "sensitivity",
         .head = "c_i",
         .is_symbol = true,
         .title = "c",
         .help = "Sensitivity coefficient, unit of the output quantity per unit of the component",
         .rule = {.digits = 3}},
        [](L l) -> Cell {
            return Measured{l.row.sensitivity, Scale::interval, l.output.unit, l.component.unit};
        });
    add({.key = "contribution",
         .head = "|cᵢ|·u(xᵢ)",
         .title = "|c|·u",
         .help = "Contribution to the standard uncertainty",
         .rule = {.digits = 2},
         .unit = unit},
        [](L l) { return interval(l.row.contribution, l.output.unit); });
    add({.key = "share of variance",
         .head = "Share of variance in %",
         .title = "Share / %",
         .help = "Of the variance, with its part of the covariances",
         .rule = {.decimals = 1, .percent = true}},
        [](L l) { return interval(l.row.share, Unit{}); });
    add({.key = "one at a time",
         .head = "alone, Monte Carlo,",
         .title = "u one at a time",
         .help = "By Monte Carlo with every other component held",
         .rule = {.digits = 2},
         .unit = unit},
        [](L l) { return l.row.one_at_a_time ? interval(*l.row.one_at_a_time, l.output.unit) : Cell(); });
    add({.key = "held"}, [](L l) -> Cell { return Answer{l.component.held}; });
    add({.key = "origin", .title = "Origin", .help = "Where the figure comes from"},
        [](L l) -> Cell { return l.component.origin; });
    return table;
}

}  // namespace covaria
