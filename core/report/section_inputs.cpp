// Input quantities and where their uncertainties come from; quantities with equal components share a row.
#include <algorithm>
#include <map>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "core/report/report_parts.h"
#include "core/report/table_text.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t listed_one_by_one = 24;  // up to here every quantity has a row of its own
constexpr std::size_t smallest_collapsed = 5;  // so many quantities with equal components share a row

std::string type_text(EvaluationType type) {
    return type == EvaluationType::type_a ? "A" : "B";
}

/// What must agree for two quantities to share a row: their components with their uncertainties, or, where
/// several components make one (the axes of a tilted frame), what the components are and the uncertainty they
/// combine to.
std::string signature(const InputSet& inputs, std::size_t index) {
    const InputQuantity& quantity = inputs.quantities[index];
    std::string text = quantity.unit.text() + "\n" +
                       (quantity.combination == Combination::arithmetic ? "arithmetic" : "quadrature");
    const bool combined = quantity.shares.size() > 1;
    if (combined) text += "\n" + format_significant(standard_uncertainty_of(inputs, index), 4);
    for (const Share& share : quantity.shares) {
        const UncertaintyComponent& c = inputs.components[share.component];
        text += "\n" + c.name + "|" + std::string(c.distribution.kind()) + "|" + c.origin + "|" +
                format_exact(c.degrees_of_freedom) + type_text(c.type) + (c.held ? "h" : "");
        if (!combined)
            text += "|" + format_exact(std::abs(share.factor) * c.distribution.standard_uncertainty());
    }
    return text;
}

using Members = std::vector<std::size_t>;

/// Quantities in order of first appearance; one list per row of the table.
std::vector<Members> rows_of(const InputSet& inputs) {
    std::map<std::string, Members> alike;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) alike[signature(inputs, i)].push_back(i);
    std::vector<Members> rows;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        const Members& members = alike[signature(inputs, i)];
        const bool collapse =
            inputs.quantities.size() > listed_one_by_one && members.size() >= smallest_collapsed;
        if (!collapse)
            rows.push_back({i});
        else if (members.front() == i)
            rows.push_back(members);
    }
    return rows;
}

std::string symbols_text(const InputSet& inputs, const Members& members) {
    std::vector<std::string> symbols;
    for (const std::size_t i : members) symbols.push_back(inputs.quantities[i].symbol);
    return short_list(symbols);
}

std::string names_text(const InputSet& inputs, const Members& members) {
    const InputQuantity& first = inputs.quantities[members.front()];
    if (members.size() == 1) return first.name;
    return first.name + " … " + inputs.quantities[members.back()].name;
}

std::vector<TableCell> component_cells(const UncertaintyComponent& c, double factor, const Unit& unit) {
    return {interval_in(unit, std::abs(factor) * c.distribution.standard_uncertainty()),
            std::string(drawn_distribution(c).title()) + (c.held ? ", held" : ""), type_text(c.type),
            shown_degrees_of_freedom(c.degrees_of_freedom), c.origin.empty() ? c.name : c.origin};
}

/// The origin that all components of the quantity have in common: "typed; ", else nothing.
std::string origins_text(const InputSet& inputs, const InputQuantity& quantity) {
    const std::string& origin = inputs.components[quantity.shares.front().component].origin;
    const bool same = std::all_of(quantity.shares.begin(), quantity.shares.end(), [&](const Share& share) {
        return inputs.components[share.component].origin == origin;
    });
    return same && !origin.empty() ? origin + "; " : "";
}

void add_quantity(TableBuilder& table, const InputSet& inputs, const Members& members) {
    const InputQuantity& quantity = inputs.quantities[members.front()];
    std::vector<TableCell> cells = {symbols_text(inputs, members), names_text(inputs, members), TableCell{},
                                    unit_text(quantity.unit)};
    if (members.size() == 1) cells[2] = value_in(quantity.unit, estimate_of(inputs, members.front()));
    const auto append = [](std::vector<TableCell> row, const std::vector<TableCell>& more) {
        row.insert(row.end(), more.begin(), more.end());
        return row;
    };
    if (quantity.shares.empty()) {
        table.row(append(cells, {Quantity{0.0, quantity.unit}, std::string("constant")}));
    } else if (quantity.shares.size() == 1) {
        const Share& share = quantity.shares.front();
        table.row(
            append(cells, component_cells(inputs.components[share.component], share.factor, quantity.unit)));
    } else {
        const bool linear = quantity.combination == Combination::arithmetic;
        const double nu = shown_degrees_of_freedom(degrees_of_freedom_of(inputs, members.front()));
        table.row(append(
            cells, {interval_in(quantity.unit, standard_uncertainty_of(inputs, members.front())),
                    std::string("combined"), TableCell{}, nu,
                    origins_text(inputs, quantity) + std::to_string(quantity.shares.size()) +
                        (linear ? " components, added arithmetically" : " components, in quadrature")}));
        if (members.size() > 1) return;  // their shares differ from one to the next: see the CSV table
        for (const Share& share : quantity.shares) {
            const UncertaintyComponent& c = inputs.components[share.component];
            table.row(append({TableCell{}, "– " + c.name, TableCell{}, unit_text(quantity.unit)},
                             component_cells(c, share.factor, quantity.unit)));
        }
    }
}

void add_correlations(Blocks& blocks, const InputSet& inputs) {
    if (inputs.correlations.empty()) return;
    TableBuilder table("input-correlations", "Correlation coefficients of components");
    table.text("Component");
    table.text("Component");
    table.symbol("r", 3);
    for (const ComponentCorrelation& c : inputs.correlations)
        table.row({inputs.components[c.first].id, inputs.components[c.second].id, c.coefficient});
    blocks.push_back(table.take());
}

}  // namespace

void add_inputs(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const InputSet& inputs = evaluated.result->inputs;
    blocks.push_back(HeadingBlock{2, "Input quantities"});
    TableBuilder table("inputs-" + evaluated.analysis->id,
                       "Input quantities and the origin of their uncertainties");
    table.text("Symbol", true);
    table.text("Quantity");
    table.estimate("Estimate", false, 4);
    table.text("Unit");
    table.symbol("u(x_i)", 3);
    table.text("Distribution");
    table.text("Type");
    table.symbol("nu_i");
    table.text("Origin");
    const std::vector<Members> rows = rows_of(inputs);
    for (const Members& members : rows) add_quantity(table, inputs, members);
    if (rows.size() < inputs.quantities.size())
        table.note(std::to_string(inputs.quantities.size()) +
                   " input quantities; many with equal components share a row. The CSV table of inputs lists "
                   "every one with its estimate.");
    blocks.push_back(table.take());
    add_correlations(blocks, inputs);
}

}  // namespace covaria::report_parts
