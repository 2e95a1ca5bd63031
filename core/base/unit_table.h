// The units Covaria knows, with their exact factors to SI. A new unit is one line in unit_table.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/unit.h"

namespace covaria::detail {

struct UnitEntry {
    std::string_view name;     ///< in files: "um"
    std::string_view display;  ///< for people: "µm"
    double numerator;          ///< one unit = numerator/denominator in SI
    double denominator;
    Dimension dimension;
    double offset = 0.0;  ///< SI value of zero on the scale (degC)
};

std::span<const UnitEntry> unit_table();

/// The entry with this name, or null.
const UnitEntry* find_unit(std::string_view name);

/// The names most like an unknown one, as a sentence for the user: ' Did you mean "mm" or "um"?'; lists all
/// units when none is alike.
std::string unit_suggestion(std::string_view unknown);

}  // namespace covaria::detail
