// Stated against seen uncertainties in results.json and of `covaria seen --json`.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/evidence/seen.h"

namespace covaria {

/// The global test and, for each figure, the stated u and what the residuals see of it; null for what is not
/// known.
nlohmann::ordered_json seen_json(const evidence::RedundantReadings& readings, const evidence::Seen& seen);

}  // namespace covaria
