// Sensitivity coefficients of an adjusted network: the gain of each unknown, a row at a time.
#pragma once

#include <memory>

#include "core/kinds/network/adjusted_trials.h"

namespace covaria::network {

/// The rows at x, whose number is that of the outputs: unknowns, then distances. Null: the model has no value
/// there. `network` and `trials` outlive the source.
std::unique_ptr<const SensitivitySource> sensitivities_at(const AdjustedNetwork& network,
                                                          const AdjustedTrials& trials,
                                                          std::span<const double> x);

}  // namespace covaria::network
