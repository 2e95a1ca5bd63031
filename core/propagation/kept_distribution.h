// The distribution of an output that is kept after its trials are gone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/propagation/order_statistics.h"
#include "core/propagation/pilot.h"
#include "core/result/trial_distribution.h"

namespace covaria::detail {

/// Tails: order statistics, each of the most extreme 32 and then at ranks 3 % apart, exact there. Body: every
/// second of the cells of the histogram (1/100 of the range of 10 u each), linear in between, and the parts
/// of divided cells; values that recurred in the pilot are jumps. So a probability read from it differs from
/// the share of the trials by less than the scatter of that share between runs. The tails are finished.
TrialDistribution kept_distribution(const OutputPilot& pilot, const std::vector<std::uint64_t>& counts,
                                    const std::vector<std::uint64_t>& parts, const Tails& tails);

}  // namespace covaria::detail
