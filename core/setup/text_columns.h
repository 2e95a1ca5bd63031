// Meaning of the texts of a set-up: which columns name quantities, which fields name units.
#pragma once

#include <string>
#include <string_view>

#include "core/setup/setup_schema.h"

namespace covaria {

/// Whether the texts of a column are symbols, however short: "theta" is set as θ.
inline bool names_quantities(const ColumnSpec& column) {
    return column.key == "symbol" || column.key == "quantity";
}

/// Whether the text of a field or column is a unit as it was typed, "um", which is read as "µm".
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
