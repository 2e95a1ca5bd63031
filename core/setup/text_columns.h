// What the texts of a set-up are: which columns name quantities, which fields name units.
#pragma once

#include <string_view>

#include "core/setup/setup_schema.h"

namespace covaria {

/// Its texts are symbols, however short: "theta" is set as θ.
inline bool names_quantities(const ColumnSpec& column) {
    return column.key == "symbol";
}

/// Of a field or column: its text is a unit as it was typed, "um", and is read as "µm".
inline bool names_unit(std::string_view key) {
    return key.ends_with("unit");
}

}  // namespace covaria
