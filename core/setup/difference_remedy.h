// The way out where a temperature stands for a difference (core/base/temperature.h).
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/temperature.h"
#include "core/setup/message_text.h"

namespace covaria {

/// The way out by which a figure in `given` becomes a difference in K; none where the objection is another
/// one. `unit_place`: of the unit, relative as the path of the problem.
inline std::vector<Remedy> remedies_as_difference(const Message& words, const Unit& given,
                                                  const Unit& expected, const std::string& unit_place) {
    const Unit kelvin = Unit::of("K");
    if (given.dimension() != expected.dimension() || !is_reading_for_difference(given, expected)) return {};
    return {{words, {{unit_place, kelvin.text()}}}};
}

/// The same for one figure with its unit at `place`: "a difference: 20 K".
inline std::vector<Remedy> remedies_as_difference(const Quantity& given, const Unit& expected,
                                                  const std::string& place) {
    return remedies_as_difference(tell<"a difference: %1">(quantity_words(given.value, Unit::of("K"))),
                                  given.unit, expected, place + "/unit");
}

}  // namespace covaria
