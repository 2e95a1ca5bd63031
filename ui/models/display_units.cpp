// Choice of units for display.
#include "ui/models/display_units.h"

#include <algorithm>
#include <array>

namespace covaria::ui {

void DisplayUnits::choose(const Unit& unit) {
    std::erase_if(chosen_, [&](const Unit& other) { return other.dimension() == unit.dimension(); });
    chosen_.push_back(unit);
}

const Unit& DisplayUnits::of(const Unit& unit) const {
    for (const Unit& chosen : chosen_)
        if (chosen.dimension() == unit.dimension()) return chosen;
    return unit;
}

std::vector<Unit> DisplayUnits::choices(const Unit& unit) {
    static constexpr std::array<const char*, 27> usual{
        "m",      "cm",     "mm", "um", "nm", "rad", "mrad", "urad", "deg",
        "arcmin", "arcsec", "N",  "kN", "mN", "N*m", "N*mm", "K",    "degC",
        "s",      "ms",     "kg", "g",  "V",  "mV",  "mV/V", "1/K",  "%"};
    std::vector<Unit> units;
    for (const char* text : usual) {
        const Result<Unit> candidate = Unit::parse(text);
        if (candidate && candidate->dimension() == unit.dimension()) units.push_back(*candidate);
    }
    if (std::find(units.begin(), units.end(), unit) == units.end()) units.insert(units.begin(), unit);
    return units;
}

std::shared_ptr<const UncertaintyResult> in_units(const std::shared_ptr<const UncertaintyResult>& result,
                                                  const DisplayUnits& units) {
    if (!result || units.chosen().empty()) return result;
    auto shown = std::make_shared<UncertaintyResult>(*result);
    for (OutputResult& output : shown->outputs) output.quantity.unit = units.of(output.quantity.unit);
    return shown;
}

}  // namespace covaria::ui
