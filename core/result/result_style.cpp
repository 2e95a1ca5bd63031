#include "core/result/result_style.h"

#include <algorithm>

namespace covaria {

bool has_unit(const DisplayUnits& units, const Dimension& dimension) {
    return std::any_of(units.chosen().begin(), units.chosen().end(),
                       [&](const Unit& unit) { return unit.dimension() == dimension; });
}

bool same_units(const DisplayUnits& a, const DisplayUnits& b) {
    return a.chosen() == b.chosen();
}

DisplayUnits with_preferred(const DisplayUnits& units, const DisplayUnits& preferred) {
    DisplayUnits both = units;
    for (const Unit& unit : preferred.chosen())
        if (!has_unit(units, unit.dimension())) both.choose(unit);
    return both;
}

void take_style(OutputQuantity& output, const ResultStyle& style) {
    output.unit = style.units.of(output.unit);
}

void take_style(UncertaintyResult& result, const ResultStyle& style) {
    for (OutputResult& output : result.outputs) take_style(output.quantity, style);
}

}  // namespace covaria
