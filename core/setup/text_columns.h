// What the texts of a set-up are: which columns name quantities, which fields name units.
#pragma once

#include <string>
#include <string_view>

#include "core/setup/setup_schema.h"

namespace covaria {

/// Its texts are symbols, however short: "theta" is set as θ.
inline bool names_quantities(const ColumnSpec& column) {
    return column.key == "symbol" || column.key == "quantity";
}

/// Of a field or column: its text is a unit as it was typed, "um", and is read as "µm".
inline bool names_unit(std::string_view key) {
    return key.ends_with("unit");
}
/// A unit that was typed ("um", "kg/m^3") as people read it; other texts as they are.
inline std::string shown_text(std::string_view key, const std::string& text) {
    if (!names_unit(key) || text.empty()) return text;
    const Result<Unit> unit = Unit::parse(text);
    return unit ? unit->display() : text;
}

}  // namespace covaria
