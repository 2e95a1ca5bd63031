// The columns of joint coverage regions.
#include "core/base/name.h"
#include "core/views/result_columns.h"

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
    Table table{"regions", "Joint coverage regions", result.regions.size()};
    const auto add = [&](const char* key, auto get) -> Column& {
        return table.add(key, [&result, get](std::size_t row) -> Cell { return get(result.regions[row]); });
    };
    add("group", [](R r) -> Cell { return r.group; });
    add("group in words", [](R r) -> Cell { return r.group.empty() ? tell<"all">() : said_name(r.group); })
        .print("Group")
        .not_in_files();
    add("outputs", [&result](R r) -> Cell { return symbols_of(result, r); });
    add("symbols",
        [&result](R r) -> Cell {
            Symbols symbols;
            for (const std::size_t i : r.outputs) symbols.push_back(result.outputs[i].quantity.symbol);
            return symbols;
        })
        .print("Quantities")
        .of_symbols()
        .not_in_files();
    add("coverage probability", [&result](R) -> Cell { return Measured{result.coverage_probability}; });
    add("ellipsoid first order",
        [](R r) -> Cell { return r.singular ? Cell() : Measured{r.ellipsoid_first_order}; })
        .print("ellipsoid, law of prop.")
        .fixed(3);
    add("rectangle first order", [](R r) -> Cell { return Measured{r.rectangle_first_order}; })
        .print("rectangle, law of prop.")
        .fixed(3);
    add("ellipsoid Monte Carlo", [](R r) { return factor(r.ellipsoid_monte_carlo); })
        .print("ellipsoid, Monte Carlo")
        .fixed(3);
    add("rectangle Monte Carlo", [](R r) { return factor(r.rectangle_monte_carlo); })
        .print("rectangle, Monte Carlo")
        .fixed(3);
    add("trials", [](R r) -> Cell { return Measured{static_cast<double>(r.trials)}; });
    add("singular", [](R r) -> Cell { return Answer{r.singular}; });
    return table;
}

}  // namespace covaria
