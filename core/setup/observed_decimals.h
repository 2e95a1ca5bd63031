// How observations in the table of a set-up are written: those of one series with as many decimals.
#pragma once

#include <cstddef>
#include <vector>

#include "core/setup/setup.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Of the number in each row, as `common_decimals` has them; empty for a column that is not observed.
std::vector<int> observed_decimals(const FieldSpec& field, const SetupTable& table, std::size_t column);

}  // namespace covaria
