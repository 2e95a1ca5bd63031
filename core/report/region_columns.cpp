// Joint coverage regions.
#include "core/report/result_columns.h"

namespace covaria {
namespace {

using R = const CoverageRegion&;

Cell factor(const std::optional<double>& value) {
    return value ? Cell(Measured{*value}) : Cell();
}

std::string symbols_of(const UncertaintyResult& result, R region) {
    std::string symbols;
    for (const std::size_t i : region.outputs)
        symbols += (symbols.empty() ? "" : " ") + result.outputs[i].quantity.symbol;
    return symbols;
}

}  // namespace

Table regions_table(const UncertaintyResult& result) {
    Table table{"regions", "Joint coverage regions", {}, result.regions.size()};
    const auto add = [&](Column column, auto get) {
        column.cell = [&result, get](std::size_t row) -> Cell { return get(result.regions[row]); };
        table.columns.push_back(std::move(column));
    };
    const NumberRule three{.decimals = 3};
    add({.key = "group"}, [](R r) -> Cell { return r.group; });
    add({.key = "group in words", .head = "Group"},
        [](R r) -> Cell { return r.group.empty() ? "all" : r.group; });
    add({.key = "outputs"}, [&result](R r) -> Cell { return symbols_of(result, r); });
    add({.key = "size", .head = "Quantities", .rule = {.decimals = 0}},
        [](R r) -> Cell { return Measured{static_cast<double>(r.outputs.size())}; });
    add({.key = "coverage probability"},
        [&result](R) -> Cell { return Measured{result.coverage_probability}; });
    add({.key = "ellipsoid first order", .head = "ellipsoid, law of prop.", .rule = three},
        [](R r) -> Cell { return Measured{r.ellipsoid_first_order}; });
    add({.key = "rectangle first order", .head = "rectangle, law of prop.", .rule = three},
        [](R r) -> Cell { return Measured{r.rectangle_first_order}; });
    add({.key = "ellipsoid Monte Carlo", .head = "ellipsoid, Monte Carlo", .rule = three},
        [](R r) { return factor(r.ellipsoid_monte_carlo); });
    add({.key = "rectangle Monte Carlo", .head = "rectangle, Monte Carlo", .rule = three},
        [](R r) { return factor(r.rectangle_monte_carlo); });
    add({.key = "trials"}, [](R r) -> Cell { return Measured{static_cast<double>(r.trials)}; });
    add({.key = "singular"}, [](R r) -> Cell { return Answer{r.singular}; });
    return table;
}

}  // namespace covaria
