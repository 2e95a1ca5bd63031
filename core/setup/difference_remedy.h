// The ways out where a temperature stands for a difference (core/base/temperature.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/temperature.h"
#include "core/setup/column_words.h"
#include "core/setup/message_text.h"

namespace covaria {

/// `remedy`, by which figures in `given` become differences; none where the objection is another one.
inline std::vector<Remedy> remedies_as_difference(const Unit& given, const Unit& expected, Remedy remedy) {
    if (given.dimension() != expected.dimension() || !is_reading_for_difference(given, expected)) return {};
    return {std::move(remedy)};
}

/// The way out for figures that `of` names ("t"), with their unit at `unit_place`, relative as the path of
/// the problem: differences are given in K, or in degR where the figures are in degF.
inline std::vector<Remedy> remedies_as_difference(const Message& of, const Unit& given, const Unit& expected,
                                                  const std::string& unit_place) {
    const Unit interval = given.interval();
    return remedies_as_difference(
        given, expected,
        {tell<"a difference: %1 in %2">(of, interval.display()), {{unit_place, interval.text()}}});
}

/// The same for one figure with its unit at `place`: "a difference: 20 K".
inline std::vector<Remedy> remedies_as_difference(const Quantity& given, const Unit& expected,
                                                  const std::string& place) {
    const Unit interval = given.unit.interval();
    return remedies_as_difference(given.unit, expected,
                                  {tell<"a difference: %1">(quantity_words(given.value, interval)),
                                   {{place + "/unit", interval.text()}}});
}

/// The same for the cells of a column, whose unit is in its head, of the table at `place`.
inline std::vector<Remedy> remedies_as_difference(const ColumnSpec& column, const Unit& given,
                                                  const std::string& place) {
    const Unit interval = given.interval();
    return remedies_as_difference(
        given, column.unit,
        {tell<"a difference: %1 in %2">(column_title(column), interval.display()),
         {{place + "/columns/" + column.key, column.key + " [" + interval.text() + "]"}}});
}

}  // namespace covaria
