// Correlation coefficients of output quantities, and of components of input quantities.
#include <algorithm>
#include <memory>

#include "core/views/result_columns.h"

namespace covaria {
namespace {

Eigen::MatrixXd correlation_among(const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    return correlation_of(result.covariance.among(outputs));
}

struct CorrelatedComponent {
    std::size_t ComponentCorrelation::*which;
    const char *label, *symbol, *component, *id;
};
constexpr CorrelatedComponent first_side{&ComponentCorrelation::first, "label", "symbol", "component", "id"};
constexpr CorrelatedComponent other_side{&ComponentCorrelation::second, "other label", "other symbol",
                                         "other component", "other id"};

/// The symbols of the quantities that have each component.
std::vector<Symbols> symbols_of_components(const InputSet& inputs) {
    std::vector<Symbols> symbols(inputs.components.size());
    for (const InputQuantity& quantity : inputs.quantities)
        for (const Share& share : quantity.shares) {
            Symbols& of = symbols.at(share.component);
            if (of.empty() || of.back() != quantity.symbol) of.push_back(quantity.symbol);
        }
    return symbols;
}

}  // namespace

Table correlation_table(const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    const auto matrix = std::make_shared<const Eigen::MatrixXd>(correlation_among(result, outputs));
    const auto quantity = [&](std::size_t i) -> const OutputQuantity& { return result.outputs[i].quantity; };
    const bool one_group = std::all_of(outputs.begin(), outputs.end(), [&](std::size_t i) {
        return quantity(i).group == quantity(outputs.front()).group;
    });
    Table table{"correlation", "Correlation coefficients", outputs.size()};
    Symbols symbols;
    for (const std::size_t i : outputs) symbols.push_back(quantity(i).symbol);
    table.add("output symbol", [symbols](std::size_t row) -> Cell { return Symbols{symbols[row]}; })
        .print_symbol("r")
        .of_symbols();
    for (std::size_t c = 0; c < outputs.size(); ++c) {
        const OutputQuantity& q = quantity(outputs[c]);
        const auto column = static_cast<Eigen::Index>(c);
        table
            .add(q.group.empty() ? q.symbol : q.symbol + " (" + q.group + ")",
                 [matrix, column](std::size_t row) -> Cell {
                     return Measured{(*matrix)(static_cast<Eigen::Index>(row), column)};
                 })
            .print_symbol(q.symbol)
            .window(symbol_text(q.symbol) + (one_group || q.group.empty() ? "" : ", " + q.group))
            .tip(q.name)
            .fixed(3);
    }
    return table;
}

std::vector<ComponentCorrelation> all_correlations(const InputSet& inputs) {
    return resolved_correlations(inputs).value_or(inputs.correlations);
}

Table input_correlations_table(const InputSet& inputs, std::vector<ComponentCorrelation> of) {
    const auto pairs = std::make_shared<const std::vector<ComponentCorrelation>>(std::move(of));
    const auto symbols = std::make_shared<const std::vector<Symbols>>(symbols_of_components(inputs));
    Table table{"input-correlations", "Correlation coefficients of components", pairs->size()};
    const auto add = [&](const char* key, std::size_t ComponentCorrelation::*which, auto get) -> Column& {
        return table.add(key, [pairs, which, get](std::size_t i) -> Cell { return get((*pairs)[i].*which); });
    };
    for (const CorrelatedComponent& side : {first_side, other_side}) {
        add(side.label, side.which,
            [&inputs](std::size_t c) -> Cell { return Symbols{symbol_of_component(inputs, c)}; })
            .print("Component")
            .of_symbols()
            .not_in_files();
        add(side.symbol, side.which, [symbols](std::size_t c) -> Cell { return (*symbols)[c]; });
        add(side.component, side.which,
            [&inputs](std::size_t c) -> Cell { return inputs.components[c].name; });
        add(side.id, side.which, [&inputs](std::size_t c) -> Cell { return inputs.components[c].id; });
    }
    table.add("r", [pairs](std::size_t i) -> Cell { return Measured{(*pairs)[i].coefficient}; })
        .print_symbol("r")
        .figure(3);
    return table;
}

}  // namespace covaria
