// Decimals that the numbers of a column in the table of a set-up share: zeros that were typed stay, 26.010
// beside 25.503.
#pragma once

#include <cstddef>
#include <vector>

#include "core/setup/setup.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Of the number in each row, as `common_decimals` has them: of observations those of one series, of a column
/// in a table of what was measured all, where its rows have no units of their own. Empty for others: what was
/// chosen stays as it was typed.
std::vector<int> shared_decimals(const FieldSpec& field, const SetupTable& table, std::size_t column);

}  // namespace covaria
