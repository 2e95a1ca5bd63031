#include "core/base/temperature.h"

namespace covaria {

bool is_reading(const Unit& unit, TemperatureKind kind) {
    return unit.has_offset() || kind == TemperatureKind::reading;
}

bool is_reading_for_difference(const Unit& given, const Unit& expected) {
    return given.has_offset() && !expected.has_offset();
}

Message reading_objection(const Unit& given, const Unit& expected) {
    if (!is_reading_for_difference(given, expected)) return {};
    return tell<
        "%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a "
        "difference: give both in %1, or both in %2">(given.display(), expected.display());
}

Message factor_objection(const Message& reading, const std::string& written, const Unit& scale) {
    return tell<
        "%1 is a temperature in %3, and here it would be taken in kelvin (20 degC as 293.15 K): if it is a "
        "difference, give it in %4; for its reading in %3 write (%2 - 0 [%3]). Only the ratio of two "
        "temperatures in %3 is taken in kelvin">(reading, written, scale.text(), scale.interval().text());
}

Message multiple_objection(const Message& multiple, const Unit& scale) {
    return tell<
        "%1 is a multiple of a temperature in %2, which depends on where the scale has its zero: if the "
        "temperature is a difference, give it in %3; else multiply its reading, as in 1.5*(t - 0 [%2])">(
        multiple, scale.text(), scale.interval().text());
}

Message part_objection(const Unit& of_value) {
    if (!of_value.has_offset()) return {};
    return tell<
        "a part (%, ppm) or multiple of a temperature in %1 depends on where the scale has its zero: "
        "give the figure in %2">(of_value.display(), of_value.interval().display());
}

Message taken_objection(const TakenTemperature& taken, const TakenTemperature& taker) {
    if (taker.unit.has_offset() && !is_reading(taken.unit, taken.kind)) {
        if (taken.kind == TemperatureKind::difference)
            return tell<
                "%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, "
                "or give %2 in K">(taken.name, taker.name, taker.unit.display());
        return tell<
            "%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in "
            "%4: give both in %4, or both in K">(taken.name, taken.unit.display(), taker.name,
                                                 taker.unit.display());
    }
    if (taken.unit.has_offset() && !is_reading(taker.unit, taker.kind))
        return tell<
            "%1 is a temperature in %2, and %3 is given in %4, which may be a difference of "
            "temperatures: give both in %2, or both in K">(taken.name, taken.unit.display(), taker.name,
                                                           taker.unit.display());
    return {};
}

}  // namespace covaria
