// The ways out where a temperature stands for a difference (core/base/temperature.h).
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/temperature.h"
#include "core/setup/column_words.h"
#include "core/setup/message_text.h"

namespace covaria {

/// The way out by which figures in `given` become differences: in K, or in degR where they are in degF; none
/// where the objection is another one. `of` says which ("t"), `unit_place` where the unit
/// is, relative as the path of the problem.
inline std::vector<Remedy> remedies_as_difference(const Message& of, const Unit& given, const Unit& expected,
                                                  const std::string& unit_place) {
    if (given.dimension() != expected.dimension() || !is_reading_for_difference(given, expected)) return {};
    const Unit interval = given.interval();
    return {{tell<"a difference: %1 in %2">(of, interval.display()), {{unit_place, interval.text()}}}};
}

/// The same for one figure with its unit at `place`: "a difference: 20 K".
inline std::vector<Remedy> remedies_as_difference(const Quantity& given, const Unit& expected,
                                                  const std::string& place) {
    auto remedies = remedies_as_difference(Message(), given.unit, expected, place + "/unit");
    for (Remedy& remedy : remedies)
        remedy.words = tell<"a difference: %1">(quantity_words(given.value, given.unit.interval()));
    return remedies;
}

/// The same for the cells of a column, whose unit is in its head. `place`: of the table.
inline std::vector<Remedy> remedies_as_difference(const ColumnSpec& column, const Unit& given,
                                                  const std::string& place) {
    auto remedies =
        remedies_as_difference(column_title(column), given, column.unit, place + "/columns/" + column.key);
    for (Remedy& remedy : remedies)
        for (Remedy::Value& value : remedy.values)
            value.value = column.key + " [" + given.interval().text() + "]";
    return remedies;
}

}  // namespace covaria
