// Decimals that the numbers of a column in the table of a set-up share: zeros that were typed stay, 26.010
// beside 25.503.
#pragma once

#include <cstddef>
#include <vector>

#include "core/setup/setup.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Decimals of the number in each row, as by `common_decimals`: shared by observations of one series, and by
/// a column of a table of what was measured, where its rows have no units of their own. Empty for others:
/// what was chosen stays as it was typed.
std::vector<int> shared_decimals(const FieldSpec& field, const SetupTable& table, std::size_t column);

}  // namespace covaria
