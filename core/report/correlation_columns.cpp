// Correlation coefficients of output quantities.
#include <algorithm>
#include <memory>

#include "core/report/result_columns.h"

namespace covaria {
namespace {

Eigen::MatrixXd correlation_among(const UncertaintyResult& result, const std::vector<std::size_t>& outputs) {
    const auto size = static_cast<Eigen::Index>(outputs.size());
    Eigen::MatrixXd covariance(size, size);
    for (Eigen::Index r = 0; r < size; ++r)
        for (Eigen::Index c = 0; c < size; ++c)
            covariance(r, c) =
                result.covariance(static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(r)]),
                                  static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(c)]));
    return correlation_of(covariance);
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
            .round({.decimals = 3});
    }
    return table;
}

}  // namespace covaria
