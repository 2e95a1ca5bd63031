// The columns of an uncertainty budget.
#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/propagation/sobol.h"
#include "core/views/component_labels.h"
#include "core/views/result_columns.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

using Scale = Measured::Scale;
using Places = std::shared_ptr<const std::vector<BudgetPlace>>;

/// A line of a budget with its component and output.
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

/// The unit of a component: all components of a quantity are in its unit, whatever unit each was stated in.
const Unit& unit_of(const BudgetComponent& c) {
    const bool is_of_one = c.quantities.size() == 1 && c.quantity_unit.dimension() == c.unit.dimension();
    return is_of_one ? c.quantity_unit : c.unit;
}

/// The estimate of a component; none where several quantities share it, since it would be that of one of
/// them. It is in the row's unit, or has its own where the component is of another dimension than its
/// quantity.
Cell estimate_cell(const BudgetComponent& c, const NumberLocale& numbers) {
    if (c.quantities.size() > 1 || c.is_rest) return {};
    if (unit_of(c).dimension() == c.quantity_unit.dimension())
        return Measured{c.estimate, Scale::value, unit_of(c), {}};
    const Unit& own = c.quantity_unit;
    return grouped_digits(format_typed(own.from_si(c.estimate)), numbers) + unit_after_number(own);
}

/// Whether each row is the first about its quantity, where its estimate stands.
std::vector<bool> begin_quantities(const UncertaintyResult& result, const std::vector<BudgetPlace>& places) {
    std::set<std::tuple<std::size_t, std::string, std::string, double>> known;
    std::vector<bool> begin;
    for (const BudgetPlace& place : places) {
        const BudgetComponent& c =
            result.budget.components[result.budget.rows[place.output][place.row].component];
        const bool is_of_one = c.quantities.size() == 1;
        begin.push_back(!is_of_one ||
                        known.emplace(place.output, c.quantities.front(), c.group, c.estimate).second);
    }
    return begin;
}

void add_estimate(Table& table, const UncertaintyResult& result,
                  const std::shared_ptr<const std::vector<BudgetPlace>>& places,
                  const NumberLocale& numbers) {
    table
        .add("estimate",
             [&result, places, numbers, begin = begin_quantities(result, *places)](std::size_t i) -> Cell {
                 const BudgetRow& row = result.budget.rows[(*places)[i].output][(*places)[i].row];
                 return begin[i] ? estimate_cell(result.budget.components[row.component], numbers) : Cell();
             })
        .print_symbol("x_i")
        .input_of("u")
        .not_in_files();
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

/// The Sobol index of the component at a place, which correlated ones share; null where it is not evaluated,
/// or left out.
const SobolIndex* sobol_at(const UncertaintyResult& result, const BudgetPlace& place) {
    if (place.output >= result.sobol.size()) return nullptr;
    const std::size_t component = result.budget.rows[place.output][place.row].component;
    for (const SobolIndex& index : result.sobol[place.output])
        if (std::find(index.components.begin(), index.components.end(), component) != index.components.end())
            return &index;
    return nullptr;
}

bool has_interactions(const UncertaintyResult& result, const BudgetPlace& place) {
    const SobolIndex* index = sobol_at(result, place);
    return index && index->total > detail::least_total_index;
}

/// Adds columns of Sobol indices for the window; files and reports have a table of them.
void add_sobol_columns(Table& table, const UncertaintyResult& result, const Places& places) {
    const auto add = [&](const char* key, double SobolIndex::*share) -> Column& {
        return table
            .add(key,
                 [&result, places, share](std::size_t i) -> Cell {
                     const SobolIndex* index = sobol_at(result, (*places)[i]);
                     return index ? Cell(Measured{index->*share}) : Cell();
                 })
            .percent(1)
            .not_in_files();
    };
    const NumberRule two_digits{.role = NumberRole::figure, .digits = 2, .percent = true};
    add("sobol standard error", &SobolIndex::first_standard_error).round(two_digits);
    add("sobol total standard error", &SobolIndex::total_standard_error).round(two_digits);
    add("sobol", &SobolIndex::first)
        .window("S / %", "Share of the variance that the component causes by itself (Sobol index)");
    add("sobol total", &SobolIndex::total)
        .window("S total / %", "Share of the variance with all interactions of the component with others");
}

}  // namespace

std::vector<BudgetPlace> budget_places(const UncertaintyResult& result, std::size_t output) {
    std::vector<BudgetPlace> places;
    if (output < result.budget.rows.size())
        for (std::size_t i = 0; i < result.budget.rows[output].size(); ++i) places.push_back({output, i});
    return places;
}

std::vector<BudgetPlace> places_that_count(const UncertaintyResult& result, std::size_t output) {
    const double combined = result.outputs[output].first_order.standard_uncertainty;
    std::vector<BudgetPlace> places = budget_places(result, output);
    std::erase_if(places, [&](const BudgetPlace& place) {
        const BudgetRow& row = result.budget.rows[output][place.row];
        return row.contribution < 1e-9 * combined &&
               !(row.one_at_a_time && *row.one_at_a_time > 1e-9 * combined) &&
               !has_interactions(result, place);
    });
    return places;
}

std::vector<BudgetRow> rows_at(const UncertaintyResult& result, const std::vector<BudgetPlace>& places) {
    std::vector<BudgetRow> rows;
    for (const BudgetPlace& place : places) rows.push_back(result.budget.rows[place.output][place.row]);
    return rows;
}

Table budget_table(const UncertaintyResult& result, std::vector<BudgetPlace> at,
                   const DocumentLanguage& language) {
    const std::optional<Unit> unit = common_unit(result, at);
    const auto places = std::make_shared<const std::vector<BudgetPlace>>(std::move(at));
    Table table{"budget", "Uncertainty budgets", places->size()};
    using L = const BudgetLine&;
    const auto add = [&](const char* key, auto get) -> Column& {
        return table.add(key, of_line(result, places, get));
    };
    // Many components together have a contribution and a share, and no other figure in common.
    const auto add_of_one = [&](const char* key, auto get) -> Column& {
        return add(key, [get](L l) { return l.component.is_rest ? Cell() : Cell(get(l)); });
    };
    add("group", [](L l) -> Cell { return l.output.group; });
    add("output", [](L l) -> Cell { return Symbols{l.output.symbol}; });
    add("output unit", [](L l) -> Cell { return l.output.unit; });
    add("quantity", [](L l) -> Cell { return l.component.quantities; })
        .print("Symbol")
        .window("Quantities", "Input quantities that the component is part of")
        .of_symbols();
    add_label_column(table, [&result, places, language] {
        return component_labels(result.budget, rows_at(result, *places), language);
    });
    add("component", [](L l) -> Cell { return l.component.name; }).window("Component of uncertainty");
    add("component in words",
        [](L l) -> Cell {
            return l.component.held ? tell<"%1 (constant)">(l.component.name) : l.component.name;
        })
        .print("Component")
        .not_in_files();
    add("id", [](L l) -> Cell { return l.component.id; });
    add_of_one("unit", [](L l) -> Cell { return unit_of(l.component); })
        .print("Unit")
        .window("Unit", "Of the component's u");
    add_estimate(table, result, places, language.numbers());
    add_of_one("u", [](L l) { return interval(l.component.standard_uncertainty, unit_of(l.component)); })
        .print_symbol("u(x_i)")
        .window("u", "Standard uncertainty of the component")
        .uncertainty()
        .of_row({"estimate", "u"});
    add_of_one("distribution", [](L l) -> Cell { return l.component.distribution; })
        .print("Distribution")
        .window("Distribution")
        .of_own_words();
    add_of_one("type", [](L l) -> Cell { return result_words::type_text(l.component.type); })
        .print("Type")
        .window("Type", "Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)");
    add_of_one("degrees of freedom", [](L l) -> Cell { return Measured{l.component.degrees_of_freedom}; })
        .print_symbol("nu_i")
        .window(symbol_text("nu"), "Degrees of freedom")
        .degrees_of_freedom();
    add_of_one("sensitivity",
               [](L l) -> Cell {
                   return Measured{l.row.sensitivity, Scale::interval, l.output.unit, unit_of(l.component)};
               })
        .print_symbol("c_i")
        .window("c", "Sensitivity coefficient, unit of the output quantity per unit of the component")
        .figure_no_fewer(sensitivity_digits)
        .with_unit();
    add_of_one("sensitivity unit", [](L l) -> Cell { return quotient(l.output.unit, unit_of(l.component)); });
    add("contribution", [](L l) { return interval(l.row.contribution, l.output.unit); })
        .print(unit ? "|cᵢ|·u(xᵢ) in %1" : "|cᵢ|·u(xᵢ)")
        .window("|c|·u", "Contribution to the standard uncertainty")
        .uncertainty()
        .in(unit);
    add("share of variance", [](L l) -> Cell { return Measured{l.row.share}; })
        .print("Share of variance in %")
        .window("Share / %", "Of the variance, with its part of the covariances")
        .percent(1);
    add("one at a time",
        [](L l) { return l.row.one_at_a_time ? interval(*l.row.one_at_a_time, l.output.unit) : Cell(); })
        .print("alone, Monte Carlo, in %1")
        .window("u one at a time", "By Monte Carlo with every other component kept constant")
        .uncertainty()
        .in(unit);
    add_sobol_columns(table, result, places);
    add("held", [](L l) -> Cell { return Answer{l.component.held}; });
    add("origin", [](L l) -> Cell {
        return l.component.origin;
    }).window("Origin", "Where the figure comes from");
    return table;
}

}  // namespace covaria
