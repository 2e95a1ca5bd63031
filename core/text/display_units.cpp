// Choice of units for display.
#include "core/text/display_units.h"

#include <algorithm>
#include <array>

namespace covaria {

namespace {

/// Whether `given` may be shown in `shown`: a value in K may be a difference, which no other zero suits.
bool fits(const Unit& shown, const Unit& given) {
    return shown.dimension() == given.dimension() && (!shown.has_offset() || given.has_offset());
}

}  // namespace

void DisplayUnits::choose(const Unit& unit) {
    std::erase_if(chosen_, [&](const Unit& other) { return other.dimension() == unit.dimension(); });
    chosen_.push_back(unit);
}

const Unit& DisplayUnits::of(const Unit& unit) const {
    for (const Unit& chosen : chosen_)
        if (fits(chosen, unit)) return chosen;
    return unit;
}

std::vector<Unit> DisplayUnits::choices(const Unit& unit) {
    static constexpr std::array usual{
        "m",   "cm",   "mm",     "um",     "nm",  "in",   "ft",   "thou", "rad",  "mrad", "urad",
        "deg", "gon",  "arcmin", "arcsec", "N",   "kN",   "mN",   "lbf",  "N*m",  "N*mm", "K",
        "mK",  "degC", "degF",   "d",      "h",   "min",  "s",    "ms",   "us",   "kg",   "g",
        "mg",  "lb",   "V",      "mV",     "uV",  "A",    "mA",   "ohm",  "kohm", "L",    "mL",
        "Pa",  "kPa",  "MPa",    "bar",    "psi", "Hz",   "kHz",  "mol",  "mmol", "W",    "mW",
        "J",   "kJ",   "rad/s",  "rpm",    "m/s", "km/h", "mV/V", "1/K",  "%",    "ppm"};
    std::vector<Unit> units;
    for (const char* text : usual) {
        const Result<Unit> candidate = Unit::parse(text);
        if (candidate && fits(*candidate, unit)) units.push_back(*candidate);
    }
    if (std::find(units.begin(), units.end(), unit) == units.end()) units.insert(units.begin(), unit);
    return units;
}

}  // namespace covaria
