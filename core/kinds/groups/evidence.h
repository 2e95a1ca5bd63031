// Observations in groups as evidence for or against what is stated of their scatter.
#pragma once

#include <memory>

#include "core/evidence/redundant_readings.h"
#include "core/kinds/groups/setup.h"

namespace covaria::group_observations {

/// Each round of the estimate costs the third power of it: seconds for more.
inline constexpr std::size_t most_held_between = 600;

/// Evidence about the standard deviations that are stated within the groups and between them. Of groups that
/// are summed up, contrasts of their observations count in the place of these, and have no w of their own.
/// Null: nothing is stated, or there are more observations than `evidence::most_readings`, with a scatter
/// between the groups than `most_held_between`.
std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const GroupSetup& setup);

}  // namespace covaria::group_observations
