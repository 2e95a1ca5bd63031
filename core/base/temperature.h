// Temperature is not a difference of temperatures: the one rule for what may be done with either.
//
// A unit with a zero of its own (degC, degF) states a reading on its scale. K (and degR, the interval of
// degF) states a difference of temperatures or a thermodynamic temperature, so a reading may be given in K,
// but a difference never in degC. Of readings
// there are the difference of two, the ratio of two (in kelvin), the mean, and one shifted by a difference.
// Everything else would depend on where the scale has its zero. Equations, statements, links, limits,
// studies, designs and imports ask here.
#pragma once

#include <string>

#include "core/base/message.h"
#include "core/base/unit.h"

namespace covaria {

/// Meaning of a value with the dimension of temperature, where more is known than its unit says, as K may
/// stand for either.
enum class TemperatureKind {
    by_unit,     ///< a reading in degC, not known in K
    reading,     ///< also where it is given in K
    difference,  ///< difference of two readings
};

/// Whether the value is known to be a temperature, not a difference.
bool is_reading(const Unit& unit, TemperatureKind kind = TemperatureKind::by_unit);

/// Whether a value typed in `given` cannot stand where one in `expected` is asked for: a reading for a
/// difference. (A temperature typed in K is one in kelvin.) For uncertainties and widths neither matters:
/// they are intervals.
bool is_reading_for_difference(const Unit& given, const Unit& expected);
/// Why, where a quantity is given in `expected` and something about its value in `given`; empty: it can.
Message reading_objection(const Unit& given, const Unit& expected);

/// Objection to a reading in a product, a quotient, a power or a function that would take it in kelvin.
/// `written` is how an equation has it: "t"; `scale` its unit.
Message factor_objection(const Message& reading, const std::string& written, const Unit& scale);
/// Objection to a multiple of a reading ("1.001*t"): it has no place on the scale.
Message multiple_objection(const Message& multiple, const Unit& scale);
/// Why no part of a value in this unit can be stated (in %, ppm), nor a multiple of it be taken; empty: it
/// can.
Message part_objection(const Unit& of_value);

/// A value that is taken from elsewhere (a link).
struct TakenTemperature {
    Message name = {};
    Unit unit = {};
    TemperatureKind kind = TemperatureKind::by_unit;
};
/// Why it cannot be the value of `taker`, which has the same dimension: one is a temperature, the other is
/// not. Empty: it can.
Message taken_objection(const TakenTemperature& taken, const TakenTemperature& taker);

}  // namespace covaria
