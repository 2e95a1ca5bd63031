// Which column of a set-up's table names quantities.
#pragma once

#include "core/setup/setup_schema.h"

namespace covaria {

/// Its texts are symbols, however short: "theta" is set as θ.
inline bool names_quantities(const ColumnSpec& column) {
    return column.key == "symbol";
}

}  // namespace covaria
