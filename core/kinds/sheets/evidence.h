// Readings of a field procedure as evidence for or against the standard deviation that is stated of them.
#pragma once

#include <memory>

#include "core/evidence/redundant_readings.h"
#include "core/kinds/sheets/distance_meter_fit.h"
#include "core/kinds/sheets/theodolite_fit.h"

namespace covaria::sheets {

/// Evidence about the standard deviation of one distance. Null: none is stated.
std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const DistanceMeterSetup& setup,
                                                                      const DistanceMeterFit& fit);
/// Evidence about the standard deviations of a direction and of a zenith angle, each the mean of both faces.
/// Null: neither is stated.
std::shared_ptr<const evidence::RedundantReadings> redundant_readings(const TheodoliteSetup& setup,
                                                                      const TheodoliteFit& fit);

}  // namespace covaria::sheets
